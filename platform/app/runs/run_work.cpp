#include "app/runs/run_work.h"

#include "app/runs/replicates.h"
#include "app/runs/worker_setup.h"
#include "app/terminal/output.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/time_limit.h"
#include "app/workspace/run_inputs.h"
#include "app/workspace/used_plugins.h"
#include "foundation/plugins/plugin_fault.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "report/text/run_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

std::string summary(const ReplicateEnd& end, const std::vector<TargetTrialRow>& trials) {
  std::uint64_t evaluations = 0;
  for (const PassRow& pass : end.passes) evaluations += pass.evaluations + pass.test_evaluations;
  const bool stopped = !end.passes.empty() && !end.passes.back().stopped.empty();
  return passes_text(end.passes, trials) +
         (stopped ? fmt::format("stopped after pass {}: {}\n", end.passes.back().number, end.passes.back().stopped)
                  : "") +
         fmt::format("run {} · {} · {} evaluations · storage {:.1f} % of the time\n", end.planned.run.value,
                     format_duration(end.seconds), evaluations, 100.0 * end.storage_seconds / end.process_seconds);
}

std::string runs_named(const std::vector<std::int64_t>& runs) {
  return fmt::format("{} {}", runs.size() == 1 ? "run" : "runs", fmt::join(runs, ", "));
}

/// A line for each reason for which replicates failed.
std::string failures_of(const std::vector<ReplicateEnd>& ends) {
  std::vector<std::pair<std::string, std::vector<std::int64_t>>> reasons;
  for (const ReplicateEnd& end : ends) {
    if (end.ending != RunEnding::failed) continue;
    auto reason = std::find_if(reasons.begin(), reasons.end(), [&](const auto& r) { return r.first == end.problem; });
    if (reason == reasons.end()) reason = reasons.insert(reason, {end.problem, {}});
    reason->second.push_back(end.planned.run.value);
  }
  std::string failures;
  for (const auto& [problem, runs] : reasons) failures += runs_named(runs) + ": " + problem + "\n";
  return failures;
}

/// Throws where the database is not where it was opened any more, since the last commit included.
void check_kept(const std::vector<ReplicateEnd>& ends, Database& database) try {
  database.check_in_place();
} catch (const Error& lost) {
  const std::string failures = failures_of(ends), why = lost.what();
  std::string message = failures;
  if (failures.find(why) == std::string::npos) message += why + "\n";
  message += database.file().string() + " is no longer the database of this run";
  if (database.has_moved())
    message +=
        ". To continue the run, repeat the command with --resume and --db FILE; FILE is the file with the stored rows";
  throw Error(message);
}

/// Throws where a replicate did not reach its end. `command` goes on.
void judge(const std::vector<ReplicateEnd>& ends, const std::string& command, const Stop& stop) {
  const std::string failures = failures_of(ends);
  const bool interrupted = std::any_of(ends.begin(), ends.end(),
                                       [](const ReplicateEnd& end) { return end.ending == RunEnding::interrupted; });
  if (std::any_of(ends.begin(), ends.end(), [](const ReplicateEnd& end) { return end.damaged; }))
    throw Error(failures + "earlier results may be lost; run again with --db and another file");
  const std::string again = command + " continues from here";
  if (!failures.empty()) throw Error(failures + "nothing is lost; correct the cause, then " + again);
  if (interrupted)
    throw Interrupted((stop.limit_was_reached() ? stop.reason_of_limit() : "interrupted") + "; " + again);
}

/// What the command line lacks to go on: with the next build of a plugin that ended the run, too.
std::string options_to_go_on(const std::vector<ReplicateEnd>& ends, const RunOptions& options,
                             const OpenEeaRun& opened) {
  if (!options.task.empty()) return "";
  std::string more = options.resume ? "" : " --resume";
  const std::string failures = failures_of(ends);
  if (!blames_plugin(failures)) return more;
  const std::vector<std::string>& accepted = options.accepted_plugins;
  for (const PluginFileRecord& plugin : plugins_of_run(opened.opened().experiment, *opened.opened().catalog)) {
    const std::string name = plugin_name(plugin);
    if (failures.find(plugin.file) != std::string::npos &&
        std::find(accepted.begin(), accepted.end(), name) == accepted.end())
      more += " --accept-plugin " + shell_word(name);
  }
  return more;
}

void print_ends(const std::vector<ReplicateEnd>& ends, ExperimentId experiment, Database& database) {
  if (ends.size() == 1) {
    std::mutex unused;
    const EeaStore store(database, unused, ends.front().planned.run, experiment);
    std::fputs(summary(ends.front(), store.trial_rows()).c_str(), stdout);
  } else {
    std::fputs(runs_text(eea_runs(database)).c_str(), stdout);
  }
}

/// What to type next. The database of a task moves to its plan.
void print_next(const std::vector<ReplicateEnd>& ends, const Database& database) {
  if (std::any_of(ends.begin(), ends.end(), [](const ReplicateEnd& end) { return !end.passes.empty(); }))
    fmt::print("→ lacuna plot {}\n", shell_word(database.file().string()));
}

/// Requests of the command line that are ignored, in sentences.
std::vector<std::string> not_done(const RunOptions& options, const Experiment& experiment, const RunPlan& plan,
                                  bool goes_on) {
  std::vector<std::string> all = plan.left;
  if (goes_on && options.replicates)
    all.push_back("--replicates is ignored: --resume continues existing runs and begins no new ones");
  if (!experiment.sweep.empty() && options.task.empty())
    all.push_back(experiment.file.string() +
                  " has a [sweep], which only `lacuna plan` uses; this run takes the values of the other sections");
  return all;
}

/// A supervisor types the same line again, whatever became of the run.
void say_finished(const RunOptions& options, const std::string& experiment, RunId run, const std::string& database) {
  fmt::print(takes_standard_output(options.json) ? stderr : stdout,
             "{} is finished: run {} in {} is done. To begin a new run, leave out --resume\n→ lacuna runs {}\n",
             experiment, run.value, database, shell_word(database));
}

}  // namespace

void carry_out_run(const RunOptions& options) {
  check_output(options.json);
  const OpenEeaRun opened(open_experiment(options));
  opened.opened().tell_doubts();
  const std::filesystem::path file = database_of(options, opened.opened().experiment);
  ask_target(opened);  // what does not fit is said before a run begins
  Database database = Database::open(file, options.stop);
  const bool goes_on = options.resume && has_run(database, opened);
  RunPlan plan = goes_on ? unfinished_runs(options, opened, database) : begin_runs(options, opened, database);
  if (options.resume && !goes_on && !options.quiet)
    fmt::print(stderr, "{} has no run of {} yet, so a new one begins\n", file.string(),
               opened.opened().experiment.name);
  if (!options.quiet)
    for (const std::string& reason : not_done(options, opened.opened().experiment, plan, goes_on))
      fmt::print(stderr, "{}\n", reason);
  for (const auto& [run, plugin] : plan.rebuilt)
    fmt::print(stderr,
               "run {} continues with another build of {}; its rows so far come from the build with SHA-256 {:.12}…, "
               "so no single build reproduces the run\n",
               run.value, plugin.now.file, plugin.before.sha256);
  if (plan.finished) return say_finished(options, opened.opened().experiment.name, *plan.finished, file.string());
  RunLines lines(options.json, goes_on);  // a refused run leaves the file of an earlier one
  lines.begin(opened.opened().experiment.name, plan.threads, plan.replicates);
  const std::unique_ptr<WorkerPool> workers = worker_pool(options, opened, plan.threads);
  std::vector<ReplicateEnd> ends;
  {
    RunDisplay display(plan.replicates, options.quiet, &lines);
    ends = Replicates(opened, database, plan.experiment, workers.get()).run(plan.replicates, plan.threads, display);
  }
  RunClaim::release(plan.claims);
  options.stop.lift_limit();  // what follows is quick
  check_kept(ends, database);
  if (!takes_standard_output(options.json)) {
    print_ends(ends, plan.experiment, database);
    if (options.task.empty()) print_next(ends, database);
  }
  judge(ends, command_line() + options_to_go_on(ends, options, opened), options.stop);
  lines.throw_if_failed();
}

}  // namespace lacuna
