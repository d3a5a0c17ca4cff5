#include "app/tasks/carry_out_task.h"

#include "app/runs/run_work.h"
#include "app/tasks/task_checkpoints.h"
#include "app/tasks/task_left.h"
#include "app/terminal/scratch_folder.h"
#include "app/terminal/supervised.h"
#include "app/workspace/diagnosis_work.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "storage/core/storage_error.h"
#include "tasks/task_database.h"

#include <fmt/format.h>

#include <functional>

namespace lacuna {
namespace {

template <class Options>
Options options_of(const TaskPlan& plan, const Task& task, const std::filesystem::path& database) {
  Options options;
  options.experiment = task.experiment;
  options.overrides = task.settings;
  options.plugin_paths = plan.plugin_paths;
  options.database = database;
  options.seed = task.seed;
  options.task = task.id;
  return options;
}

struct TaskWork {
  const TaskFolder& folder;
  std::size_t number;
  int threads;
  bool quiet;
};

void do_work(const TaskWork& work, const std::filesystem::path& database, bool goes_on) {
  const TaskPlan& plan = work.folder.plan();
  const Task& task = work.folder.task(work.number);
  if (task.kind == TaskKind::run) {
    RunOptions options = options_of<RunOptions>(plan, task, database);
    options.threads = work.threads;
    options.quiet = work.quiet;
    options.only_replicate = task.replicate;
    options.resume = goes_on;
    carry_out_run(options);
  } else {
    DiagnoseOptions options = options_of<DiagnoseOptions>(plan, task, database);
    options.threads = work.threads;
    options.quiet = work.quiet;
    carry_out_diagnosis(options);
  }
}

void check_inputs(const TaskFolder& folder, const Task& task) {
  ProblemList problems;
  for (const std::string& changed : changed_inputs(folder.plan(), task))
    problems.add({folder.path().string()}, changed + "; restore it, or make a new plan");
  problems.throw_if_any();
}

/// What cannot be moved to the plan stays where it is. `before`: what else went wrong.
void hand_in(const TaskWork& work, ScratchFolder& scratch, const std::string& before,
             const std::function<void()>& move) try {
  move();
} catch (const std::exception& lost) {
  scratch.keep();
  throw Error(fmt::format("{}{}{}\n{}", before, before.empty() ? "" : "\n", lost.what(),
                          where_it_stays(work.folder.path(), work.number, scratch.path())));
}

/// Whether there is a checkpoint to go on from, which becomes the task's database. One that cannot be used is kept, and
/// the task begins anew.
bool take_checkpoint(const TaskWork& work, const std::filesystem::path& database) {
  if (!work.folder.take_checkpoint(work.number, database)) return false;
  const auto fault =
      why_not_of_task(database, work.folder.task(work.number), TaskDatabase::checkpoint, when_interrupted());
  if (!fault) return true;
  std::filesystem::remove(database);
  fmt::print(stderr, "{}: {}; it is kept as {}, and the task starts again\n",
             work.folder.checkpoint(work.number).string(), plain_text(fault->reason),
             work.folder.put_checkpoint_aside(work.number).string());
  return false;
}

void carry_out(const TaskWork& work) {
  check_inputs(work.folder, work.folder.task(work.number));
  ScratchFolder scratch;
  const std::filesystem::path database = scratch / "shard.db";
  leave_to_supervisor(TaskLeft{work.folder.path(), work.number, scratch.path()}.text());
  const auto keep_checkpoint = [&] { work.folder.keep_checkpoint(work.number, database); };
  try {
    const bool goes_on = take_checkpoint(work, database);
    const TaskCheckpoints checkpoints(work.folder, work.number, database);
    do_work(work, database, goes_on);
  } catch (const Interrupted& interruption) {
    hand_in(work, scratch, "", keep_checkpoint);
    work.folder.note_interruption(work.number, interruption.what());
    throw Interrupted(fmt::format("task {} was interrupted; to continue: {}", work.number, command_line()));
  } catch (const DamagedDatabase&) {
    throw;
  } catch (const std::exception& failure) {
    hand_in(work, scratch, failure.what(), keep_checkpoint);
    throw;
  }
  hand_in(work, scratch, "", [&] { work.folder.keep_shard(work.number, database); });
}

}  // namespace

void carry_out_task(const TaskFolder& folder, std::size_t number, int threads, bool quiet) {
  folder.task(number);
  const std::string shard = plain_text(folder.shard(number).string());
  if (folder.is_done(number)) {
    if (!quiet) fmt::print("task {} is done already: {}\n", number, shard);
    return;
  }
  folder.make_ready();
  const TaskSign sign(folder, number);
  try {
    carry_out({folder, number, threads, quiet});
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& failure) {
    folder.note_failure(number, failure.what());
    throw;
  }
  if (!quiet) fmt::print("task {} is done: {}\n", number, shard);
}

}  // namespace lacuna
