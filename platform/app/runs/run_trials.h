#pragma once

#include "eea/definition/eea_definition.h"
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

/// The same as it is stored, whatever the experiment says.
struct KeptTrial {
  TargetTrialRow row;
  Genome genome;
  Trial trial;
};

/// All trials of the run, by number. Throws `Error` where one is not what its digest says, and `DamagedDatabase` where
/// rows contradict each other.
std::vector<KeptTrial> stored_trials(const EeaStore& store);

RunTrial run_trial(const EeaDefinition& definition, KeptTrial stored);

/// As a test with unknown outcome: its controller, if there is one, reacts to the model, whatever commands the
/// target received.
ScoredTrial as_new_trial(const RunTrial& trial);

/// All trials of the run, by number.
std::vector<RunTrial> run_trials(const EeaStore& store, const EeaDefinition& definition);

}  // namespace lacuna
