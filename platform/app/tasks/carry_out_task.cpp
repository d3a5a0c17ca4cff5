#include "app/tasks/carry_out_task.h"

#include "app/runs/run_work.h"
#include "app/terminal/scratch_folder.h"
#include "app/workspace/diagnosis_work.h"
#include "foundation/interrupt.h"
#include "foundation/plain_text.h"
#include "foundation/problem.h"
#include "storage/core/storage_error.h"

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

struct Work {
  const TaskFolder& folder;
  std::size_t number;
  int threads;
  bool quiet;
};

void do_work(const Work& work, const std::filesystem::path& database, bool goes_on) {
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
    problems.add({folder.path().string()}, changed + "; put it back, or make a new plan");
  problems.throw_if_any();
}

/// What cannot be moved to the plan stays where it is.
void hand_in(ScratchFolder& scratch, const std::function<void()>& move) try {
  move();
} catch (const std::exception& lost) {
  scratch.keep();
  throw Error(fmt::format("{}\nwhat was found until then is in {}", lost.what(), scratch.path().string()));
}

void carry_out(const Work& work) {
  check_inputs(work.folder, work.folder.task(work.number));
  ScratchFolder scratch;
  const std::filesystem::path database = scratch / "shard.db";
  const auto keep_checkpoint = [&] { work.folder.keep_checkpoint(work.number, database); };
  try {
    do_work(work, database, work.folder.take_checkpoint(work.number, database));
  } catch (const Interrupted& interruption) {
    hand_in(scratch, keep_checkpoint);
    work.folder.note_interruption(work.number, interruption.what());
    throw Interrupted(fmt::format("task {} was interrupted; to continue: {}", work.number, command_line()));
  } catch (const DamagedDatabase&) {
    throw;
  } catch (const std::exception&) {
    hand_in(scratch, keep_checkpoint);
    throw;
  }
  hand_in(scratch, [&] { work.folder.keep_shard(work.number, database); });
}

}  // namespace

void carry_out_task(const TaskFolder& folder, std::size_t number, int threads, bool quiet) {
  folder.task(number);
  const std::string shard = plain_text(folder.shard(number).string());
  if (folder.is_done(number)) {
    if (!quiet) fmt::print("task {} is done: {}\n", number, shard);
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
