#include "prediction/acceleration_steps.h"

#include "foundation/statistics.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kNoise = 0.01;  ///< of a channel's RMS change in a step: what is smaller is taken for noise
constexpr double kStepsOfAnInterval = 16.0;  ///< of the readings: in so short a time friction stops no light joint
constexpr double kRounding = 1e-6;

/// Every `stride`-th sample of a trial and, one step later, what its acceleration makes of it.
Trial pairs_of(const Trial& trial, std::size_t number, const LadderSource& source, double step, Eigen::Index stride) {
  Trial pairs = trial;
  pairs.initial.clear();
  pairs.centre_of_mass = {};
  const Eigen::Index count = (trial.measured.times.size() + stride - 1) / stride;
  pairs.measured.times.resize(2 * count);
  pairs.measured.samples.resize(2 * count, trial.measured.samples.cols());
  for (Eigen::Index i = 0; i < count; ++i)
    for (const Eigen::Index after : {0, 1}) {
      const double later = after == 0 ? 0.0 : step;
      pairs.measured.times(2 * i + after) = trial.measured.times(i * stride) + later;
      pairs.measured.samples.row(2 * i + after) = source.starts.readings_after(number, i * stride, later).transpose();
    }
  return pairs;
}

/// By channel of the ladder's noise, the changes in a step.
std::vector<std::vector<double>> changes_of(const std::vector<Trial>& trials, const PredictionLadder& ladder) {
  std::vector<std::vector<double>> changes(ladder.noise.size());
  for (const PredictedStretch& stretch : ladder.stretches)
    for (std::size_t i = 0; i < stretch.rows.size(); ++i) {
      const TimeSeries::Samples& samples = trials[stretch.stretch.trial].measured.samples;
      const Eigen::Index first = stretch.stretch.first, column = stretch.columns[i];
      changes[stretch.channels[i]].push_back(samples(first + 1, column) - samples(first, column));
    }
  return changes;
}

}  // namespace

AccelerationSteps acceleration_steps(const LadderSource& source, const EngineSettings& engine, std::size_t most) {
  const std::vector<Trial>& trials = source.predictor.trials();
  std::size_t samples = 0;
  double shortest = engine.step;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].held_out) continue;
    if (!source.states.reconstructible(t)) return {};
    const Eigen::VectorXd& times = trials[t].measured.times;
    shortest = std::min(shortest, (times.tail(times.size() - 1) - times.head(times.size() - 1)).minCoeff());
    samples += static_cast<std::size_t>(times.size());
  }
  const auto stride = static_cast<Eigen::Index>((samples + most - 1) / most);
  AccelerationSteps steps;
  steps.engine = engine;
  steps.engine.substeps =
      std::max(engine.substeps, static_cast<int>(std::ceil(kStepsOfAnInterval * engine.step / shortest - kRounding)));
  const double step = engine.step / steps.engine.substeps;
  for (std::size_t t = 0; t < trials.size(); ++t)
    steps.trials.push_back(trials[t].held_out ? trials[t] : pairs_of(trials[t], t, source, step, stride));
  steps.ladder = ladder_of_pairs(source, steps.trials, stride, step);
  const std::vector<std::vector<double>> changes = changes_of(steps.trials, steps.ladder);
  for (std::size_t c = 0; c < changes.size(); ++c)
    if (const double size = root_mean_square(changes[c]); size > 0.0) steps.ladder.noise[c].deviation = kNoise * size;
  return steps;
}

}  // namespace lacuna
