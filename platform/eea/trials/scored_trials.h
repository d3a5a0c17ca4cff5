#pragma once

#include "eea/definition/eea_definition.h"
#include "eea/definition/eea_state.h"

#include <vector>

namespace lacuna {

/// The trials with which models are compared in the state's pass: all so far but those that are set aside
/// (challenge.h).
std::vector<ScoredTrial> scored_trials(const EeaDefinition& definition, const EeaState& state);

/// Scores of those trials, at the positions of all trials; trials that are set aside have none.
std::vector<double> by_trial(const EeaState& state, const std::vector<double>& scores);

}  // namespace lacuna
