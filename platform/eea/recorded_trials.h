#pragma once

#include "eea/eea_definition.h"
#include "eea/eea_state.h"

#include <vector>

namespace lacuna {

/// Measured trials as the estimation phase takes them. Where a trial does not state its start, the start is read off
/// its first 50 ms, which are then not scored. Throws `Error` where a trial does not fit the model.
std::vector<TargetTrial> recorded_trials(const EeaDefinition& definition, std::vector<Trial> trials);

}  // namespace lacuna
