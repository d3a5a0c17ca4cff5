#include "bench/force_error.h"

#include "bench/zero_phase.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kEnds = 0.2;  // s, where the filter has only one side

struct Motion {
  Eigen::VectorXd position, velocity, acceleration;
};

Motion motion_of(const Eigen::VectorXd& position, double interval) {
  const Eigen::Index size = position.size();
  Motion motion{position, Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)};
  for (Eigen::Index i = 1; i + 1 < size; ++i) {
    motion.velocity(i) = (position(i + 1) - position(i - 1)) / (2.0 * interval);
    motion.acceleration(i) = (position(i + 1) - 2.0 * position(i) + position(i - 1)) / (interval * interval);
  }
  return motion;
}

/// The model's acceleration over one sample from each state.
Eigen::VectorXd predicted(const CompiledModel& model, const Trial& trial, std::span<const double> values,
                          const Motion& motion, double interval, Eigen::Index ends) {
  const TrialPredictor predictor(model, {trial}, {1});
  const double per_acceleration = 0.5 * interval * interval;
  Eigen::VectorXd found = Eigen::VectorXd::Zero(motion.position.size());
  Prediction prediction;
  for (Eigen::Index i = ends; i < found.size() - ends; ++i) {
    const StartState start{{motion.position(i)}, {motion.velocity(i)}};
    predictor.predict({0, i, i + 2}, values, start, 0, prediction);
    if (!prediction.valid) throw Error("the model cannot be simulated: " + prediction.reason);
    found(i) = (prediction.samples(1, 0) - motion.position(i) - interval * motion.velocity(i)) / per_acceleration;
  }
  return found;
}

double median(Eigen::VectorXd values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values(values.size() / 2);
}

double rms(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

}  // namespace

ForceError force_error(const CompiledModel& model, const Trial& trial, std::span<const double> values, double cutoff) {
  const Eigen::VectorXd& times = trial.measured.times;
  const double interval = (times(times.size() - 1) - times(0)) / static_cast<double>(times.size() - 1);
  const auto ends = static_cast<Eigen::Index>(kEnds / interval);
  Trial smooth = trial;
  auto& commands = smooth.commands.series.samples;
  commands.col(0) = low_passed(commands.col(0), interval, cutoff);
  const Motion motion = motion_of(low_passed(trial.measured.samples.col(0), interval, cutoff), interval);
  const auto inner = [&](const Eigen::VectorXd& all) { return all.segment(ends, all.size() - 2 * ends).eval(); };
  const Eigen::VectorXd now = predicted(model, smooth, values, motion, interval, ends);
  const double size = rms(commands.col(0));
  Trial pushed = smooth;
  pushed.commands.series.samples.array() += 0.1 * size;
  const Eigen::VectorXd more = predicted(model, pushed, values, motion, interval, ends);
  const double mobility = median(inner(more - now)) / (0.1 * size);
  const double force = rms(inner(motion.acceleration - now)) / mobility;
  return {force, force / rms(inner(commands.col(0)))};
}

}  // namespace lacuna
