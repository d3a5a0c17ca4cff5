#pragma once

#include "storage/eea/eea_records.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// A replicate that is to be run.
struct PlannedReplicate {
  RunId run;
  int replicate = 1;  ///< from 1
  std::uint64_t seed = 1;
};

/// How a replicate ended.
struct ReplicateEnd {
  PlannedReplicate planned;
  RunEnding ending = RunEnding::done;
  bool began = true;             ///< false: it was interrupted before it had its turn
  std::string problem;           ///< why it failed or was interrupted
  bool damaged = false;          ///< the database, so that what it has stored of the run may be lost
  double seconds = 0.0;          ///< of work, stretches before an interruption included
  double process_seconds = 0.0;  ///< of this process
  double storage_seconds = 0.0;  ///< of these, in commits
  std::vector<PassRow> passes;
};

}  // namespace lacuna
