#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/progress_line.h"
#include "foundation/counted.h"
#include "foundation/plain_text.h"
#include "foundation/problem.h"
#include "storage/merge/merge.h"
#include "tasks/task_folder.h"

#include <lacuna/error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace lacuna {
namespace {

struct MergeOptions {
  std::filesystem::path database;
  std::vector<std::filesystem::path> sources;
  bool quiet = false;
};

/// Databases to take in, and what is missing of plans.
struct Shards {
  std::vector<std::filesystem::path> files;
  std::string missing;  ///< a line for each task
  std::size_t tasks = 0, done = 0;
};

std::string missing_line(const TaskFolder& folder, std::size_t number) {
  const TaskStatus status = folder.status(number);
  const std::string task = fmt::format("{}: task {}", plain_text(folder.path().string()), number);
  return status.state == TaskState::failed ? fmt::format("{} failed: {}\n", task, plain_text(status.reason))
                                           : fmt::format("{} is not done\n", task);
}

void add_shards(const std::filesystem::path& plan, Shards& shards) {
  const TaskFolder folder(plan);
  for (std::size_t number = 0; number < folder.plan().tasks.size(); ++number) {
    ++shards.tasks;
    if (folder.is_done(number)) {
      ++shards.done;
      shards.files.push_back(folder.shard(number));
      continue;
    }
    shards.missing += missing_line(folder, number);
  }
}

/// An empty file would be taken for a database without tables.
void check_not_empty(const std::vector<std::filesystem::path>& files) {
  ProblemList problems;
  for (const std::filesystem::path& file : files) {
    std::error_code missing;
    if (std::filesystem::file_size(file, missing) == 0 && !missing)
      problems.add({file.string()}, "is empty; of a plan, remove it, and `lacuna task run` makes it anew");
  }
  problems.throw_if_any();
}

/// Of a merge that is refused nothing is left where there was nothing.
std::vector<MergedShard> merged(const MergeOptions& options, const std::vector<std::filesystem::path>& files) {
  const bool was_there = std::filesystem::exists(options.database);
  try {
    Database database = Database::open(options.database);
    ProgressLine line(options.quiet);
    return merge(database, files, [&](double part) { line.show({.what = "merge", .fraction = part}); });
  } catch (const BadInput&) {
    std::error_code ignored;
    if (!was_there) std::filesystem::remove(options.database, ignored);
    throw;
  }
}

void print(const MergeOptions& options, const std::vector<MergedShard>& shards) {
  std::size_t added = 0, known = 0;
  for (const MergedShard& shard : shards) {
    added += shard.added.size();
    known += shard.known.size();
  }
  fmt::print("{}: {} added{}\n", plain_text(options.database.string()), counted(added, "run"),
             known > 0 ? fmt::format(", {} there already", known) : "");
}

void merge_databases(const MergeOptions& options) {
  Shards shards;
  for (const std::filesystem::path& source : options.sources) {
    if (std::filesystem::is_directory(source))
      add_shards(source, shards);
    else
      shards.files.push_back(source);
  }
  check_not_empty(shards.files);
  if (!shards.files.empty()) {
    const std::vector<MergedShard> found = merged(options, shards.files);
    if (!options.quiet) print(options, found);
  }
  if (!shards.missing.empty())
    throw Error(fmt::format("{}{} of {} tasks are merged; run the others, then repeat this command", shards.missing,
                            shards.done, shards.tasks));
}

}  // namespace

void add_merge_command(CLI::App& program) {
  auto options = std::make_shared<MergeOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("merge", "Take the runs of other databases, or of a plan's tasks, into one");
  add_database_argument(*command, options->database);
  command->add_option("shards", options->sources, "Databases, or folders of plans")
      ->required()
      ->option_text("SHARD...");
  command->add_flag("--quiet", options->quiet, "Print nothing");
  command->callback([options] { merge_databases(*options); });
}

}  // namespace lacuna
