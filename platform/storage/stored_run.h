#pragma once

#include "storage/database.h"
#include "storage/records.h"

#include <vector>

namespace lacuna {

/// What a run was started from: enough to run it again.
struct StoredRun {
  ExperimentRecord experiment;
  std::uint64_t seed = 0;
  int threads = 1;
  std::vector<PluginFileRecord> plugins;  ///< by file
  std::vector<RobotFileRecord> robots;    ///< by file; none where an older version began the run
};

/// Throws `Error` where the database has no such run.
StoredRun stored_run(const Database& database, RunId run);

}  // namespace lacuna
