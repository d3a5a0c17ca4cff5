#include "app/runs/run_plan.h"

#include "app/runs/replicates.h"
#include "app/workspace/run_inputs.h"
#include "app/workspace/used_plugins.h"
#include "config/result_setting.h"
#include "foundation/parallel.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "storage/results/result_store.h"
#include "storage/results/stored_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace lacuna {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kEnding{2};  ///< that a process which was killed may take until it has ended

std::string given(const std::vector<std::string>& overrides) {
  if (overrides.empty()) return "no --set";
  std::vector<std::string> words;
  for (const std::string& override : overrides) words.push_back("--set " + shell_word(override));
  return fmt::format("{}", fmt::join(words, " "));
}

bool is_accepted(const ChangedPlugin& changed, const RunOptions& options) {
  const std::vector<std::string>& names = options.accepted_plugins;
  return std::find(names.begin(), names.end(), plugin_name(changed.now)) != names.end();
}

/// A name that is no plugin's may be a slip.
void check_accepted(const RunOptions& options, const OpenEeaRun& opened) {
  std::vector<std::string> used;
  for (const PluginFileRecord& file : plugins_of_run(opened.opened().experiment, *opened.opened().catalog))
    used.push_back(plugin_name(file));
  ProblemList problems;
  for (const std::string& name : options.accepted_plugins)
    if (std::find(used.begin(), used.end(), name) == used.end())
      problems.add({}, fmt::format("--accept-plugin {}: the experiment uses no plugin of that name{}; it uses {}", name,
                                   did_you_mean(name, used), fmt::join(used, ", ")));
  problems.throw_if_any();
}

/// How a run can continue with the present builds of its plugins.
std::string how_to_accept(const std::vector<ChangedPlugin>& changed) {
  std::vector<std::string> options;
  for (const ChangedPlugin& plugin : changed)
    options.push_back("--accept-plugin " + shell_word(plugin_name(plugin.now)));
  return fmt::format(
      ", or accept the new build{} with {}: the rows so far stay from the old build, and no single build reproduces "
      "the "
      "run",
      changed.size() == 1 ? "" : "s", fmt::join(options, " "));
}

/// Differences between the settings at the beginning of the run and now; empty: it can continue. How a target's program
/// is run does not count: a limit may be raised, and a rig may have another port.
std::string difference(const StoredRun& stored, const RunOptions& options, const OpenEeaRun& opened) {
  const Experiment& file = opened.opened().experiment;
  std::vector<std::string> other;
  if (!same_values(result_setting(stored.experiment.text, stored.experiment.overrides),
                   result_setting(file.text, file.overrides))) {
    if (stored.experiment.text != file.text) other.push_back("another version of this experiment");
    if (stored.experiment.overrides != file.overrides) other.push_back(given(stored.experiment.overrides));
  }
  if (options.seed && *options.seed != stored.seed) other.push_back(fmt::format("--seed {}", stored.seed));
  for (std::string& changed : changed_robots(stored, file)) other.push_back(std::move(changed));
  for (const ChangedPlugin& changed : changed_plugins(stored, file, *opened.opened().catalog))
    if (!is_accepted(changed, options)) other.push_back(to_string(changed));
  return fmt::format("{}", fmt::join(other, ", with "));
}

/// Not held where another process has the run until `deadline`.
RunClaim claim_by(Clock::time_point deadline, Database& database, RunId run, const std::vector<ForeignClaim>& silent) {
  constexpr double kBetween = 0.05;  // s
  for (;;) {
    RunClaim claim(database, run, silent);
    if (claim.held() || Clock::now() >= deadline) return claim;
    database.stop().pause_for(kBetween);
  }
}

/// Adds the run to the plan, or records the reason why not. Returns whether it was begun with the present settings.
bool consider(const EeaRunListing& run, const RunOptions& options, const OpenEeaRun& opened, Database& database,
              const std::vector<ForeignClaim>& silent, Clock::time_point deadline, RunPlan& plan) {
  const StoredRun stored = stored_run(database, run.run);
  const std::string other = difference(stored, options, opened);
  const std::vector<ChangedPlugin> changed =
      changed_plugins(stored, opened.opened().experiment, *opened.opened().catalog);
  if (!other.empty()) {
    std::vector<ChangedPlugin> rebuilt = changed;
    std::erase_if(rebuilt, [&](const ChangedPlugin& plugin) { return is_accepted(plugin, options); });
    plan.left.push_back(fmt::format("run {} was begun with {}; to continue it, use the same{}", run.run.value, other,
                                    rebuilt.empty() ? "" : how_to_accept(rebuilt)));
    return false;
  }
  RunClaim claim = claim_by(deadline, database, run.run, silent);
  if (!claim.held()) {
    plan.left.push_back(fmt::format("another process is carrying out run {}", run.run.value));
    plan.taken = true;
    return true;
  }
  if (is_done(database, run.run)) return false;  // meanwhile
  plan.replicates.push_back({run.run, run.replicate, stored.seed});
  plan.claims.push_back(std::move(claim));
  for (const ChangedPlugin& plugin : changed) plan.rebuilt.emplace_back(run.run, plugin);
  return true;
}

/// The newest run that is done and was begun with what there is now. Where it is the settings that keep the newest one
/// from being it, that is said.
std::optional<RunId> finished_run(std::vector<EeaRunListing> runs, const RunOptions& options, const OpenEeaRun& opened,
                                  const Database& database, RunPlan& plan) {
  std::erase_if(runs, [](const EeaRunListing& run) { return run.ending != "done"; });
  std::string of_newest;
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    const std::string other = difference(stored_run(database, run->run), options, opened);
    if (other.empty()) return run->run;
    if (of_newest.empty()) of_newest = fmt::format("run {} is done, but it was begun with {}", run->run.value, other);
  }
  if (!of_newest.empty()) plan.left.push_back(of_newest);
  return std::nullopt;
}

[[noreturn]] void refuse(const Database& database, const std::string& name, const RunPlan& plan) {
  const SourceLocation file{database.file().string()};
  std::vector<Problem> problems;
  for (const std::string& reason : plan.left) problems.push_back({file, reason});
  problems.push_back({file, plan.taken
                                ? "has no other run of " + name + " to continue; wait for that process"
                                : "has no run of " + name + " to continue; to begin a new one, leave out --resume"});
  throw BadInput(std::move(problems));
}

/// Claims that count no more.
std::vector<ForeignClaim> silent_ones(const Database& database, const std::vector<EeaRunListing>& runs, bool quiet) {
  std::vector<RunId> open;
  for (const EeaRunListing& run : runs)
    if (run.ending != "done") open.push_back(run.run);
  return silent_claims(database, open, [&] {
    if (!quiet)
      fmt::print(stderr,
                 "{}: another machine, or this one before a restart, began to carry out a run; waiting {:g} s to see "
                 "whether it still does\n",
                 database.file().string(), kSilence);
  });
}

std::vector<EeaRunListing> runs_of(const Database& database, const std::string& experiment) {
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::erase_if(runs, [&](const EeaRunListing& run) { return run.experiment != experiment; });
  return runs;
}

}  // namespace

bool has_run(const Database& database, const OpenEeaRun& opened) {
  return !runs_of(database, opened.opened().experiment.name).empty();
}

RunPlan begin_runs(const RunOptions& options, const OpenEeaRun& opened, Database& database) {
  const Experiment& file = opened.opened().experiment;
  RunPlan plan;
  const std::uint64_t seed = options.seed.value_or(file.seed);
  plan.threads = options.work().threads;
  const std::vector<PluginFileRecord> plugins = plugins_of_run(file, *opened.opened().catalog);
  Transaction transaction(database);
  ResultStore store(database);
  const int first = options.only_replicate.value_or(1);
  const int last = options.only_replicate.value_or(options.replicates.value_or(file.replicates));
  for (int replicate = first; replicate <= last; ++replicate) {
    options.stop.throw_if_kept_waiting();
    const RunId run = store.begin_run({command_line(), seed, plan.threads, options.task}, provenance_of_this_program());
    store.record_plugins(plugins);
    store.record_robot_files(robot_files_of(file));
    plan.experiment = store.record_experiment({file.name, file.file.string(), file.text, file.overrides, file.decided});
    plan.replicates.push_back({run, replicate, seed});
    plan.claims.emplace_back(database, run);
  }
  Replicates(opened, database, plan.experiment).enter(plan.replicates);
  transaction.commit();
  store.hand_over();
  return plan;
}

RunPlan unfinished_runs(const RunOptions& options, const OpenEeaRun& opened, Database& database) {
  check_accepted(options, opened);
  RunPlan plan;
  plan.threads = options.work().threads;
  const std::string& name = opened.opened().experiment.name;
  const std::vector<EeaRunListing> runs = runs_of(database, name);
  bool unfinished = false;
  const std::vector<ForeignClaim> silent = silent_ones(database, runs, options.quiet);
  const Clock::time_point deadline = Clock::now() + kEnding;
  Clock::time_point beaten = Clock::now();
  for (const EeaRunListing& run : runs) {
    if (run.ending != "done" && consider(run, options, opened, database, silent, deadline, plan)) unfinished = true;
    if (std::chrono::duration<double>(Clock::now() - beaten).count() < kBetweenBeats) continue;
    beat_claims(database);
    beaten = Clock::now();
  }
  if (plan.replicates.empty()) {
    if (!unfinished) plan.finished = finished_run(runs_of(database, name), options, opened, database, plan);
    if (!plan.finished) refuse(database, name, plan);
    return plan;
  }
  Transaction transaction(database);
  ResultStore store(database);
  plan.experiment = store.find_experiment(name).value();
  for (const PlannedReplicate& replicate : plan.replicates) store.continue_run(replicate.run);
  for (const auto& [run, plugin] : plan.rebuilt) replace_plugin(database, run, plugin.before, plugin.now);
  Replicates(opened, database, plan.experiment).enter(plan.replicates);
  transaction.commit();
  store.hand_over();
  return plan;
}

}  // namespace lacuna
