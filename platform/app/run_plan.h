#pragma once

#include "app/eea_bench.h"
#include "app/options.h"
#include "app/replicate.h"
#include "storage/database.h"

#include <optional>
#include <vector>

namespace lacuna {

struct RunOptions : CommonOptions {
  std::optional<int> replicates;
  bool resume = false;
};

/// What the runs of a command `lacuna run` are.
struct RunPlan {
  ExperimentId experiment;
  std::uint64_t seed = 1;
  int threads = 1;
  std::vector<PlannedReplicate> replicates;
};

/// Enters new runs into the database, one a replicate.
RunPlan begin_runs(const RunOptions& options, const EeaBench& bench, Database& database);

/// This experiment's runs that are not done. Throws `BadInput` where there is none, and for every one that cannot go on
/// with the experiment, the options and the plugins there are now.
RunPlan unfinished_runs(const RunOptions& options, const EeaBench& bench, Database& database);

}  // namespace lacuna
