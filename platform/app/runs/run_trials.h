#pragma once

#include "eea/eea_definition.h"
#include "storage/eea/eea_store.h"

#include <vector>

namespace lacuna {

/// A trial of a stored run.
struct RunTrial {
  TargetTrialRow row;
  Test drive;     ///< what was done
  Genome genome;  ///< of the test; empty: of a recorded target
  Trial trial;    ///< with a start that can be simulated from
};

/// As a test whose outcome nobody knows: where it has a controller, that answers to the model, whatever commands the
/// target received.
ScoredTrial as_foretold(const RunTrial& trial);

/// All trials of the run, by number.
std::vector<RunTrial> run_trials(const EeaStore& store, const EeaDefinition& definition);

}  // namespace lacuna
