#include "app/commands.h"
#include "app/eea_bench.h"
#include "app/ledger.h"
#include "app/options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/replicates.h"
#include "app/used_plugins.h"
#include "foundation/counted.h"
#include "foundation/interrupt.h"
#include "foundation/parallel.h"
#include "report/run_text.h"
#include "storage/names.h"
#include "storage/stored_run.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <mutex>

namespace lacuna {
namespace {

using Json = nlohmann::ordered_json;

struct RunOptions : CommonOptions {
  std::optional<int> replicates;
  bool resume = false;
};

/// What the runs of this command are about.
struct RunPlan {
  ExperimentId experiment;
  std::uint64_t seed = 1;
  int threads = 1;
  std::vector<PlannedReplicate> replicates;
};

RunPlan begin_runs(const RunOptions& options, const EeaBench& bench, Database& database) {
  const Experiment& file = bench.rig().experiment;
  RunPlan plan;
  plan.seed = options.seed.value_or(file.seed);
  plan.threads = options.threads > 0 ? options.threads : default_threads();
  Transaction transaction(database);
  ResultStore store(database);
  for (int replicate = 1; replicate <= options.replicates.value_or(file.replicates); ++replicate) {
    const RunId run = store.begin_run({command_line(), plan.seed, plan.threads}, provenance_of_this_program());
    store.record_plugins(plugins_of_run(file, *bench.rig().catalog));
    plan.experiment = store.record_experiment({file.name, file.file.string(), file.text, file.overrides});
    plan.replicates.push_back({run, replicate});
  }
  Replicates(bench, database, plan.experiment, plan.seed).enter(plan.replicates);
  transaction.commit();
  store.hand_over();
  return plan;
}

/// Why the run cannot go on with what the experiment is now; empty: it can.
std::string obstacle(const StoredRun& stored, const RunOptions& options, const EeaBench& bench) {
  const Experiment& file = bench.rig().experiment;
  if (stored.experiment.text != file.text || stored.experiment.overrides != file.overrides)
    return "was begun with another text of this experiment, or with another --set";
  if (options.seed && *options.seed != stored.seed) return fmt::format("was begun with --seed {}", stored.seed);
  const std::vector<PluginFileRecord> plugins = plugins_of_run(file, *bench.rig().catalog);
  for (const PluginFileRecord& now : plugins)
    if (std::none_of(stored.plugins.begin(), stored.plugins.end(),
                     [&](const PluginFileRecord& then) { return then.sha256 == now.sha256; }))
      return "was begun with another build of " + now.file;
  return {};
}

/// This experiment's runs that are not done.
RunPlan unfinished_runs(const RunOptions& options, const EeaBench& bench, Database& database) {
  RunPlan plan;
  plan.threads = options.threads > 0 ? options.threads : default_threads();
  ResultStore store(database);
  const std::string& name = bench.rig().experiment.name;
  ProblemList problems;
  for (const EeaRunListing& run : eea_runs(database)) {
    if (run.experiment != name || run.ending == "done") continue;
    const StoredRun stored = stored_run(database, run.run);
    if (const std::string reason = obstacle(stored, options, bench); !reason.empty())
      problems.add({database.file().string()},
                   fmt::format("run {} {}; it cannot go on with what there is now", run.run.value, reason));
    plan.seed = stored.seed;
    plan.replicates.push_back({run.run, run.replicate});
  }
  problems.throw_if_any();
  if (plan.replicates.empty())
    throw_problem(SourceLocation{database.file().string()},
                  "has no run of " + name + " to go on with; every one of them is done");
  plan.experiment = store.find_experiment(name).value();
  for (const PlannedReplicate& replicate : plan.replicates) store.continue_run(replicate.run);
  Replicates(bench, database, plan.experiment, plan.seed).enter(plan.replicates);
  store.hand_over();
  return plan;
}

std::string summary(const ReplicateEnd& end, const std::vector<TargetTrialRow>& trials) {
  std::uint64_t evaluations = 0;
  for (const PassRow& pass : end.passes) evaluations += pass.evaluations + pass.test_evaluations;
  return passes_text(end.passes, trials) + fmt::format("run {} · {} · {} evaluations · storage {:.1f} % of the time\n",
                                                       end.planned.run.value, format_duration(end.seconds), evaluations,
                                                       100.0 * end.storage_seconds / end.seconds);
}

Json summary_json(const ReplicateEnd& end, const std::vector<TargetTrialRow>& trials) {
  return {{"run", end.planned.run.value},
          {"replicate", end.planned.replicate},
          {"ending", to_string(end.ending)},
          {"problem", end.problem},
          {"seconds", end.seconds},
          {"storage_seconds", end.storage_seconds},
          {"passes", passes_json(end.passes, trials)}};
}

/// Throws where a replicate did not reach its end.
void judge(const std::vector<ReplicateEnd>& ends, bool resumed) {
  std::string failures;
  bool interrupted = false;
  for (const ReplicateEnd& end : ends) {
    interrupted = interrupted || end.ending == RunEnding::interrupted;
    if (end.ending == RunEnding::failed) failures += fmt::format("run {}: {}\n", end.planned.run.value, end.problem);
  }
  if (!failures.empty()) throw Error(failures.substr(0, failures.size() - 1));
  if (interrupted)
    throw Interrupted("interrupted; " + command_line() + (resumed ? "" : " --resume") + " goes on from here");
}

void run(const RunOptions& options) {
  check_output(options.json);
  const EeaBench bench(open_rig(options));
  Database database = Database::open(database_of(options, bench.rig().experiment));
  const RunPlan plan =
      options.resume ? unfinished_runs(options, bench, database) : begin_runs(options, bench, database);
  std::vector<ReplicateEnd> ends;
  {
    RunDisplay display(static_cast<int>(plan.replicates.size()), options.quiet);
    ends = Replicates(bench, database, plan.experiment, plan.seed).run(plan.replicates, plan.threads, display);
  }
  Json json = Json::array();
  for (const ReplicateEnd& end : ends) {
    std::mutex unused;
    const std::vector<TargetTrialRow> trials =
        EeaStore(database, unused, end.planned.run, plan.experiment).trial_rows();
    if (ends.size() == 1 && !takes_standard_output(options.json)) std::fputs(summary(end, trials).c_str(), stdout);
    json.push_back(summary_json(end, trials));
  }
  if (options.json) write_output(*options.json, json.dump(2) + "\n");
  if (!takes_standard_output(options.json)) {
    if (ends.size() > 1) std::fputs(runs_text(eea_runs(database)).c_str(), stdout);
    fmt::print("→ lacuna plot {}\n", database.file().string());
  }
  judge(ends, options.resume);
}

}  // namespace

void add_run_command(CLI::App& program) {
  auto options = std::make_shared<RunOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("run", "Evolve models that explain a target, and the tests that tell most about it");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  command
      ->add_option("--replicates", options->replicates, "How often the run is repeated, instead of the file's number")
      ->option_text("N")
      ->check(CLI::Range(1, 1000000));
  command->add_flag("--resume", options->resume, "Go on with this experiment's runs that were not done");
  command->callback([options] { run(*options); });
}

}  // namespace lacuna
