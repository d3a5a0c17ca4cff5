#pragma once

#include "eea/definition/eea_definition.h"
#include "eea/definition/eea_state.h"

#include <vector>

namespace lacuna {

/// What models are held against in the state's pass: all trials so far but those that are set aside (challenge.h).
std::vector<ScoredTrial> scored_trials(const EeaDefinition& definition, const EeaState& state);

/// Scores of those trials, put at the places of all trials; what is set aside has none.
std::vector<double> by_trial(const EeaState& state, const std::vector<double>& scores);

}  // namespace lacuna
