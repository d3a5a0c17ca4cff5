#include "eea/trials/recorded_trials.h"

#include "evaluation/prediction/trial_predictor.h"
#include "fitting/starts/start_states.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lacuna {
namespace {

bool states_its_start(const Trial& trial) {
  return !trial.initial.empty() &&
         std::all_of(trial.initial.begin(), trial.initial.end(),
                     [](const InitialValue& value) { return value.knowledge == InitialKnowledge::given; });
}

/// From here on the trial states its initial state, estimated from its first samples, which are masked.
void fix_start(Trial& trial, const StartState& start) {
  trial.initial.resize(start.positions.size());
  for (std::size_t c = 0; c < trial.initial.size(); ++c) {
    if (trial.initial[c].knowledge == InitialKnowledge::given) continue;
    trial.initial[c] = {InitialKnowledge::given, start.positions[c], start.velocities[c]};
  }
  const double end_of_head = trial.measured.times(0) + kHead;
  for (Eigen::Index row = 0; row < trial.measured.times.size() && trial.measured.times(row) < end_of_head; ++row)
    trial.measured.samples.row(row).setConstant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

Trial with_known_start(const EeaDefinition& definition, Trial trial) {
  if (states_its_start(trial)) return trial;
  return std::move(recorded_trials(definition, {std::move(trial)}).front().trial);
}

std::vector<TargetTrial> recorded_trials(const EeaDefinition& definition, std::vector<Trial> trials) {
  if (std::any_of(trials.begin(), trials.end(), [](const Trial& trial) { return trial.closed_loop; }))
    throw Error(
        "target.drive is \"controllers\", but lacuna run drives models with the recorded commands; run with --set "
        "'target.drive=\"commands\"'");
  const TrialPredictor predictor(*definition.compiled, trials, {1});
  const RobotSpec& robot = definition.model.structure.robot;
  const StartStates states(robot, predictor, sensor_noise(robot, predictor.trials()));
  std::vector<TargetTrial> recorded;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    Trial& trial = trials[i];
    if (!states_its_start(trial)) fix_start(trial, states.from_samples(predictor.whole(i), 0).start);
    const double end = trial.measured.times(trial.measured.times.size() - 1);
    recorded.push_back({0, Test{trial.commands, end, {}, trial.setup.name}, std::move(trial)});
  }
  return recorded;
}

}  // namespace lacuna
