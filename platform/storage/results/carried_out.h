#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <lacuna/trial.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// Tests that a user had carried out on a target, one by one, besides those of the algorithm.

/// How it came about.
struct CarriedOutRecord {
  std::string test;    ///< as given: a line, or the name of a file
  std::string target;  ///< SHA-256 of the target's definition, including its hidden values
};

/// Trials that an experiment's targets have carried out so far, whatever the target was. 0 where there is no such
/// experiment.
std::int64_t count_carried_out(const Database& database, const std::string& experiment);

/// Stores the trial with its samples (float64). In the caller's transaction; `run` was begun by a `ResultStore`.
TrialId record_carried_out(const Database& database, RunId run, ExperimentId experiment, const Trial& trial,
                           const CarriedOutRecord& record);

/// The trials of one target, in the order in which they were carried out. Throws `Error` where one is damaged.
std::vector<Trial> carried_out_trials(const Database& database, const std::string& experiment,
                                      const std::string& target);

}  // namespace lacuna
