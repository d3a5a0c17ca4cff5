#pragma once

#include "eea/definition/eea_definition.h"
#include "eea/definition/eea_state.h"

#include <vector>

namespace lacuna {

/// The trial as it was stored or carried out, with a start that can be simulated from: where it does not state one, it
/// is read off the first 50 ms, which are then not scored.
Trial with_known_start(const EeaDefinition& definition, Trial trial);

/// Measured trials as the estimation phase takes them. Where a trial does not state its start, the start is read off
/// its first 50 ms, which are then not scored. Throws `Error` where a trial does not fit the model.
std::vector<TargetTrial> recorded_trials(const EeaDefinition& definition, std::vector<Trial> trials);

}  // namespace lacuna
