#pragma once

#include "app/runs/open_eea_run.h"
#include "app/runs/replicate.h"
#include "app/terminal/options.h"
#include "app/workspace/run_inputs.h"
#include "storage/core/database.h"
#include "storage/core/run_claim.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

struct RunOptions : CommonOptions {
  std::optional<int> replicates;
  std::optional<int> only_replicate;  ///< instead of all of them
  bool resume = false;
  std::vector<std::string> accepted_plugins;  ///< names: a run goes on with another build of them
  std::optional<bool> isolate;  ///< whether models are simulated in worker processes; none: it depends on the plugins
};

/// What the runs of a command `lacuna run` are.
struct RunPlan {
  ExperimentId experiment;
  int threads = 1;
  std::vector<PlannedReplicate> replicates;
  std::vector<RunClaim> claims;   ///< on these runs
  std::vector<std::string> left;  ///< sentences: unfinished runs that are left as they are, and why
  std::vector<std::pair<RunId, ChangedPlugin>> rebuilt;  ///< plugins of which runs go on with another build
  bool taken = false;                                    ///< one of them by another process
  std::optional<RunId> finished;                         ///< there is nothing to go on with because this run is done
};

/// Whether there is a run of this experiment to go on with, or one that is done.
bool has_run(const Database& database, const OpenEeaRun& opened);

/// Enters new runs into the database, one a replicate.
RunPlan begin_runs(const RunOptions& options, const OpenEeaRun& opened, Database& database);

/// This experiment's runs that are not done and were begun with what the experiment says now (but for comments and how
/// a target's program is run), the options, robot files and plugins are; each keeps its seed. Another build
/// of a plugin that the options accept is recorded, and noted. Where all such runs are done, the plan is only the
/// newest one's number. Throws `BadInput` where there is no such run, or another process carries it out, with the
/// reason for each that is not done.
RunPlan unfinished_runs(const RunOptions& options, const OpenEeaRun& opened, Database& database);

}  // namespace lacuna
