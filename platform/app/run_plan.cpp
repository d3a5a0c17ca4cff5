#include "app/run_plan.h"

#include "app/replicates.h"
#include "app/used_plugins.h"
#include "foundation/parallel.h"
#include "storage/stored_run.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

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

}  // namespace

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

}  // namespace lacuna
