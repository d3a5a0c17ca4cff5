#include "runs/truth_error.h"

#include <Eigen/QR>

#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kUnscored = 0.05;  // s, at the start of a trial
constexpr int kStartIterations = 4;

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

std::size_t unscored_samples(const FittedTrial& trial) {
  return static_cast<std::size_t>(std::lround(kUnscored / trial.excitation.interval));
}

/// The beginning of a trial that is not scored.
FittedTrial head_of(FittedTrial trial) {
  const std::size_t samples = unscored_samples(trial) + 1;
  for (auto& commands : trial.excitation.commands) commands.resize(samples);
  for (auto& readings : trial.readings) readings.resize(samples);
  return trial;
}

/// Where a trial starts, by least squares over its head. What the head does not tell stays at rest.
class StartFit {
 public:
  StartFit(const MadeCase& made, const Eigen::VectorXd& values, const FittedTrial& trial)
      : model_(made.truth), values_(values), head_(head_of(trial)), deviations_(deviations(made.noise)) {}

  Start run() const {
    const Eigen::Index joints = at_rest(model_.spec).position.size();
    Eigen::VectorXd state = Eigen::VectorXd::Zero(2 * joints);
    for (int i = 0; i < kStartIterations; ++i) {
      const Eigen::VectorXd left = residual(state);
      Eigen::MatrixXd derivative(left.size(), state.size());
      for (Eigen::Index k = 0; k < state.size(); ++k) {
        const double step = deviations_.front() / (k < joints ? 1.0 : kUnscored);
        Eigen::VectorXd moved = state;
        moved[k] += step;
        derivative.col(k) = (residual(moved) - left) / step;
      }
      state -= derivative.completeOrthogonalDecomposition().solve(left);
    }
    return start_at(state);
  }

 private:
  Start start_at(const Eigen::VectorXd& state) const {
    const Eigen::Index joints = state.size() / 2;
    return {state.head(joints), state.tail(joints)};
  }

  Eigen::VectorXd residual(const Eigen::VectorXd& state) const {
    const Readings predicted = predict(model_, values_, head_.excitation, start_at(state));
    std::vector<double> left;
    for (std::size_t s = 0; s < predicted.size(); ++s)
      for (std::size_t k = 0; k < predicted[s].size(); ++k)
        left.push_back((predicted[s][k] - head_.readings[s][k]) / deviations_[s]);
    return Eigen::Map<const Eigen::VectorXd>(left.data(), static_cast<Eigen::Index>(left.size()));
  }

  const PlantModel& model_;
  const Eigen::VectorXd& values_;
  FittedTrial head_;
  std::vector<double> deviations_;
};

}  // namespace

std::vector<HeldOutRecord> truth_held_out(const MadeCase& made) {
  const PlantFit fit = refitted(made);
  if (!fit.valid) return {};
  const std::size_t sensors = made.truth.spec.sensors.size();
  std::vector<double> squares(sensors, 0.0), samples(sensors, 0.0);
  for (const MadeTrial& trial : made.trials) {
    if (!trial.held_out) continue;
    const FittedTrial recorded = trial.fitted();
    const Readings predicted =
        predict(made.truth, fit.values, recorded.excitation, StartFit(made, fit.values, recorded).run());
    const std::size_t first = unscored_samples(recorded);
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
