#pragma once

#include "eea/eea_run.h"
#include "eea/target_trials.h"

namespace lacuna {

/// The Estimation-Exploration Algorithm (J. Bongard, H. Lipson, "Automatic Synthesis of Multiple Internal Models
/// Through Active Exploration"), from `state` to its end. Every generation ends with a checkpoint, from which it
/// continues with the same digits. Throws `Interrupted` between two generations, `Error` where no model or no test can
/// be evaluated.
void eea_loop(const EeaRun& run, const EeaTarget& target, EeaState& state);

/// The initial state of a run: step 1.
EeaState first_state(const EeaDefinition& definition);

}  // namespace lacuna
