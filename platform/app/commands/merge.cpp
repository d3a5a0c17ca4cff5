#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/progress_line.h"
#include "foundation/counted.h"
#include "foundation/plain_text.h"
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
    if (folder.is_done(number))
      shards.files.push_back(folder.shard(number));
    else
      shards.missing += missing_line(folder, number);
  }
}

void merge_databases(const MergeOptions& options) {
  Shards shards;
  for (const std::filesystem::path& source : options.sources) {
    if (std::filesystem::is_directory(source))
      add_shards(source, shards);
    else
      shards.files.push_back(source);
  }
  for (const std::filesystem::path& file : shards.files) refuse_empty(file);
  std::size_t added = 0, known = 0;
  if (!shards.files.empty()) {
    Database database = Database::open(options.database);
    ProgressLine line(options.quiet);
    for (const MergedShard& shard :
         merge(database, shards.files, [&](double part) { line.show({.what = "merge", .fraction = part}); })) {
      added += shard.added.size();
      known += shard.known.size();
    }
  }
  if (!options.quiet)
    fmt::print("{}: {} added{}\n", plain_text(options.database.string()), counted(added, "run"),
               known > 0 ? fmt::format(", {} there already", known) : "");
  if (!shards.missing.empty())
    throw Error(shards.missing + "what is done was merged; once the others are, the same command takes them in");
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
