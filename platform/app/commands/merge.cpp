#include "app/commands/commands.h"
#include "app/tasks/new_database.h"
#include "app/terminal/options.h"
#include "app/terminal/progress_line.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "storage/merge/merge.h"
#include "tasks/slurm_jobs.h"
#include "tasks/task_database.h"
#include "tasks/task_folder.h"

#include <lacuna/error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <list>
#include <memory>

namespace lacuna {
namespace {

struct MergeOptions {
  std::filesystem::path database;
  std::vector<std::filesystem::path> sources;
  bool quiet = false;
};

/// A database to take in.
struct Source {
  std::filesystem::path file;
  const TaskFolder* plan = nullptr;  ///< whose task it carries out; null: none
  std::size_t task = 0;
};

/// The shards to merge, and the tasks of plans that have none.
struct Sources {
  std::list<TaskFolder> plans;
  std::vector<Source> all;
  std::string missing;  ///< lines
  std::size_t tasks = 0;
};

std::string name_of(const TaskFolder& plan) { return plain_text(plan.path().string()); }

void add_plan(const std::filesystem::path& folder, Sources& sources) {
  const TaskFolder& plan = sources.plans.emplace_back(folder);
  std::vector<std::size_t> not_done;
  const auto now = plan.now();
  for (std::size_t number = 0; number < plan.plan().tasks.size(); ++number) {
    ++sources.tasks;
    if (plan.is_done(number)) {
      sources.all.push_back({plan.shard(number), &plan, number});
    } else if (const TaskStatus status = plan.status(number, now); status.state == TaskState::failed) {
      sources.missing += fmt::format("{}: task {} failed: {}\n", name_of(plan), number, plain_text(status.reason));
    } else {
      not_done.push_back(number);
    }
  }
  if (!not_done.empty())
    sources.missing +=
        fmt::format("{}: {} not done: {}\n", name_of(plan), counted(not_done.size(), "task"), array_of(not_done));
}

std::string how_to_make_anew(const Source& source) {
  return fmt::format("; move it away and carry the task out again: lacuna task run {} {}",
                     shell_word(source.plan->path().string()), source.task);
}

/// Shards that are not of their tasks.
void leave_out_strangers(Sources& sources) {
  std::erase_if(sources.all, [&](const Source& source) {
    if (source.plan == nullptr) return false;
    const auto fault =
        why_not_of_task(source.file, source.plan->task(source.task), TaskDatabase::shard, when_interrupted());
    if (fault)
      sources.missing += fmt::format("{}: {}{}\n", plain_text(source.file.string()), plain_text(fault->reason),
                                     fault->is_of_database ? how_to_make_anew(source) : "");
    return fault.has_value();
  });
}

/// An empty file would be taken for a database without tables.
void check_not_empty(const std::vector<Source>& sources) {
  ProblemList problems;
  for (const Source& source : sources) {
    std::error_code missing;
    if (source.plan == nullptr && std::filesystem::file_size(source.file, missing) == 0 && !missing)
      problems.add({source.file.string()}, "is empty; leave it out");
  }
  problems.throw_if_any();
}

std::vector<MergedShard> merged(const MergeOptions& options, const Sources& sources) {
  std::vector<Shard> shards;
  for (const Source& source : sources.all)
    shards.push_back({source.file, source.plan == nullptr ? Unusable::refuses_all : Unusable::is_left_out});
  Database database = Database::open(options.database, when_interrupted());
  ProgressLine line(options.quiet);
  return merge(database, shards, [&](double part) { line.show({.what = "merge", .fraction = part}); });
}

void print(const MergeOptions& options, const std::vector<MergedShard>& shards) {
  std::size_t added = 0, known = 0;
  for (const MergedShard& shard : shards) {
    added += shard.added.size();
    known += shard.known.size();
  }
  fmt::print("{}: {} added{}\n", plain_text(options.database.string()), counted(added, "run"),
             known > 0 ? fmt::format(", {} already present", known) : "");
}

/// What the merge has left out.
void add_left_out(const std::vector<MergedShard>& shards, Sources& sources) {
  for (std::size_t i = 0; i < shards.size(); ++i) {
    for (const Problem& problem : shards[i].problems) sources.missing += BadInput({problem}).what() + std::string("\n");
    if (shards[i].is_unsound)
      sources.missing += fmt::format("{}: rows differ from what was stored{}\n",
                                     plain_text(sources.all[i].file.string()), how_to_make_anew(sources.all[i]));
  }
}

void merge_databases(const MergeOptions& options) {
  Sources sources;
  for (const std::filesystem::path& source : options.sources) {
    if (std::filesystem::is_directory(source))
      add_plan(source, sources);
    else
      sources.all.push_back({source});
  }
  check_not_empty(sources.all);
  leave_out_strangers(sources);
  const NewDatabase database(options.database);
  std::size_t done = 0;
  if (!sources.all.empty()) {
    const std::vector<MergedShard> found = merged(options, sources);
    add_left_out(found, sources);
    if (!options.quiet) print(options, found);
    for (std::size_t i = 0; i < found.size(); ++i)
      done += found[i].problems.empty() && sources.all[i].plan != nullptr ? 1 : 0;
  }
  if (!sources.missing.empty())
    throw Error(fmt::format("{}{} of {} tasks are merged; carry out the missing ones, then repeat this command",
                            sources.missing, done, sources.tasks));
}

}  // namespace

void add_merge_command(CLI::App& program) {
  auto options = std::make_shared<MergeOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("merge", "Merge the runs of several databases, or of a plan's tasks, into one database");
  add_database_argument(*command, options->database);
  command->get_option("database")->description("Database to write the merged runs into; made if it does not exist");
  command->add_option("shards", options->sources, "Databases, or folders of plans")
      ->required()
      ->option_text("SHARD...");
  command->add_flag("--quiet", options->quiet, "Print nothing");
  command->callback([options] { merge_databases(*options); });
}

}  // namespace lacuna
