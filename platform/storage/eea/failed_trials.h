#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <string>

namespace lacuna {

/// A test that a target was asked to carry out and did not.
struct FailedTrialRecord {
  std::string trial;   ///< that it would have become: its number within a run of the algorithm, or "trial-N"
  std::string test;    ///< its number within a run of the algorithm, or as it was given
  std::string reason;  ///< a sentence
};

/// Writes it down, with the time of day. In the caller's transaction; the run was begun by a `ResultStore`.
void record_failed_trial(const Database& database, RunId run, ExperimentId experiment, const FailedTrialRecord& failed);

}  // namespace lacuna
