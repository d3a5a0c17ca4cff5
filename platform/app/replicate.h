#pragma once

#include "storage/eea_records.h"

#include <string>
#include <vector>

namespace lacuna {

/// A replicate that is to be run.
struct PlannedReplicate {
  RunId run;
  int replicate = 1;  ///< from 1
};

/// How a replicate ended.
struct ReplicateEnd {
  PlannedReplicate planned;
  RunEnding ending = RunEnding::done;
  std::string problem;  ///< why it failed or was interrupted
  double seconds = 0.0;
  double storage_seconds = 0.0;
  std::vector<PassRow> passes;
};

}  // namespace lacuna
