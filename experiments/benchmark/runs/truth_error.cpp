#include "runs/truth_error.h"

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kUnscored = 0.05;  // s, at the start of a trial

Start at_rest(const PlantSpec& spec) {
  const auto joints = static_cast<Eigen::Index>(spec.joints.size());
  return {Coordinates::Zero(joints), Coordinates::Zero(joints)};
}

/// By sensor, what a reading that is right may be off by: a quantum's share is its width over √12.
std::vector<double> deviations(const CaseNoise& noise) {
  std::vector<double> all;
  for (std::size_t s = 0; s < noise.sensor_white.size(); ++s)
    all.push_back(std::hypot(noise.sensor_white[s], noise.sensor_slow[s], noise.quantum[s] / std::sqrt(12.0)));
  return all;
}

PlantFit refitted(const MadeCase& made) {
  std::vector<FittedTrial> trials;
  for (const MadeTrial& trial : made.trials)
    if (!trial.held_out) trials.push_back(trial.fitted());
  return fit_plant(made.truth, trials, made.truth_values, std::vector<Start>(trials.size(), at_rest(made.truth.spec)),
                   by_deviation(deviations(made.noise)));
}

}  // namespace

std::vector<HeldOutRecord> truth_held_out(const MadeCase& made) {
  const PlantFit fit = refitted(made);
  if (!fit.valid) return {};
  const std::size_t sensors = made.truth.spec.sensors.size();
  std::vector<double> squares(sensors, 0.0), samples(sensors, 0.0);
  for (const MadeTrial& trial : made.trials) {
    if (!trial.held_out) continue;
    const FittedTrial recorded = trial.fitted();
    const Readings predicted = predict(made.truth, fit.values, recorded.excitation, at_rest(made.truth.spec));
    const auto first = static_cast<std::size_t>(std::lround(kUnscored / recorded.excitation.interval));
    for (std::size_t s = 0; s < sensors; ++s)
      for (std::size_t k = first; k < predicted[s].size(); ++k) {
        squares[s] += std::pow(recorded.readings[s][k] - predicted[s][k], 2);
        samples[s] += 1.0;
      }
  }
  std::vector<HeldOutRecord> errors;
  for (std::size_t s = 0; s < sensors; ++s)
    errors.push_back({"truth", made.truth.spec.sensors[s].name, std::sqrt(squares[s] / samples[s])});
  return errors;
}

}  // namespace hidden_effects
