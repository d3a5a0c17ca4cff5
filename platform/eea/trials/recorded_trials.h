#pragma once

#include "eea/definition/eea_definition.h"
#include "eea/definition/eea_state.h"

#include <vector>

namespace lacuna {

/// The trial as it was stored or carried out, with an initial state to simulate from: where it states none, the state
/// is estimated from the first 50 ms, which are then not scored.
Trial with_known_start(const EeaDefinition& definition, Trial trial);

/// Measured trials for the estimation phase. Where a trial does not state its initial state, the state is estimated
/// from its first 50 ms, which are then not scored. Throws `Error` where a trial does not fit the model.
std::vector<TargetTrial> recorded_trials(const EeaDefinition& definition, std::vector<Trial> trials);

}  // namespace lacuna
