#include "prediction/prediction_lengths.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr std::size_t kLengths = 5;
constexpr double kShortest = 10.0;     ///< samples
constexpr double kMostOfStart = 0.25;  ///< of the motion's power
constexpr double kMostPower = 0.1;     ///< rad²: more motion of a hinge than this adds no information
constexpr std::size_t kTried = 12;     ///< lengths
constexpr std::size_t kFewStretches = 24;
constexpr double kLongest = 3000.0;   ///< samples
constexpr double kStillShort = 30.0;  ///< samples: below this length a failed check does not end the search

double duration(const Trial& trial) {
  return trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0);
}

/// s, of the channel that is read most often.
double sample_interval(const std::vector<Trial>& trials) {
  double least = std::numeric_limits<double>::infinity();
  for (const Trial& trial : trials) {
    if (trial.held_out) continue;
    for (Eigen::Index c = 0; c < trial.measured.samples.cols(); ++c) {
      const auto count = static_cast<double>(trial.measured.samples.col(c).array().isFinite().count());
      if (count > 1.0) least = std::min(least, duration(trial) / (count - 1.0));
    }
  }
  return least;
}

std::vector<double> geometric(double first, double last, std::size_t count) {
  std::vector<double> lengths;
  for (std::size_t k = 0; k < count; ++k)
    lengths.push_back(first * std::pow(last / first, static_cast<double>(k) / static_cast<double>(count - 1)));
  return lengths;
}

/// Variance of a channel's readings in a stretch, over that of the reading noise.
double power_of(const PredictedStretch& stretch, const TimeSeries& measured, const ChannelNoise& noise,
                std::size_t channel) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < stretch.rows.size(); ++i) {
    if (stretch.channels[i] != channel) continue;
    const double value = measured.samples(stretch.stretch.first + stretch.rows[i], stretch.columns[i]);
    sum += value;
    squares += value * value;
    count += 1.0;
  }
  if (count == 0.0) return 0.0;
  double variance = squares / count - sum * sum / (count * count);
  if (noise.unit == "rad") variance = std::min(variance, kMostPower);
  return variance / (noise.deviation * noise.deviation);
}

/// Whether the uncertainty of the initial states is small enough at the single length of this ladder, in every channel
/// that moves.
bool means_something(const PredictionLadder& ladder, const std::vector<LinearStretch>& stretches,
                     const std::vector<Trial>& trials) {
  for (std::size_t channel = 0; channel < ladder.noise.size(); ++channel) {
    double share = 0.0, power = 0.0, count = 0.0;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const PredictedStretch& stretch = ladder.stretches[k];
      double squares = 0.0, rows = 0.0;
      for (std::size_t i = 0; i < stretch.channels.size(); ++i) {
        if (stretch.channels[i] != channel) continue;
        const auto row = stretches[k].start.row(static_cast<Eigen::Index>(i));
        squares += (row * stretch.covariance).dot(row);
        rows += 1.0;
      }
      if (rows == 0.0) continue;
      share += squares / rows;
      power += power_of(stretch, trials[stretch.stretch.trial].measured, ladder.noise[channel], channel);
      count += 1.0;
    }
    if (count > 0.0 && power > 0.0 && share > kMostOfStart * power) return false;
  }
  return !stretches.empty();
}

}  // namespace

std::vector<double> prediction_lengths(const LadderSource& source, const ParameterSpace& space,
                                       const std::vector<double>& values) {
  const std::vector<Trial>& trials = source.predictor.trials();
  const double interval = sample_interval(trials);
  double longest = 0.0;
  for (const Trial& trial : trials)
    if (!trial.held_out) longest = std::max(longest, duration(trial));
  longest = std::min(longest, kLongest * interval);
  const double shortest = std::min(kShortest * interval, longest / 3.0);
  double top = 0.0;
  for (const double length : geometric(shortest, longest, kTried)) {
    const PredictionLadder ladder = ladder_of(source, {length}, kFewStretches);
    if (ladder.stretches.empty()) continue;
    LadderPredictions predictions(ladder, source.predictor, space, source.starts);
    const auto linear = predictions.linearise(predictions.at_smoothed_starts(space.to_coordinates(values)));
    if (linear && means_something(ladder, linear->stretches, trials))
      top = length;
    else if (length > kStillShort * interval)
      break;
  }
  if (top == 0.0) top = std::min(longest, kStillShort * interval);
  top = std::max(top, std::min(longest, kStillShort * interval));
  return geometric(shortest, top, top > 1.5 * shortest ? kLengths : 2);
}

}  // namespace lacuna
