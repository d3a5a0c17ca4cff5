#include "eea/trials/scored_trials.h"

namespace lacuna {

std::vector<ScoredTrial> scored_trials(const EeaDefinition& definition, const EeaState& state) {
  std::vector<ScoredTrial> scored;
  for (const TargetTrial& trial : state.trials)
    if (!trial.set_aside_in) scored.push_back(definition.scored(trial.drive, trial.trial, state.pass));
  return scored;
}

std::vector<double> by_trial(const EeaState& state, const std::vector<double>& scores) {
  std::vector<double> placed;
  std::size_t next = 0;
  for (std::size_t t = 0; t < state.trials.size() && next < scores.size(); ++t)
    placed.push_back(state.trials[t].set_aside_in ? kNotKnown : scores[next++]);
  return placed;
}

}  // namespace lacuna
