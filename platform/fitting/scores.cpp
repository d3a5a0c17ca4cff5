#include "fitting/scores.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

double deviation_of(const std::vector<double>& values) {
  double mean = 0.0, squares = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Weighted sums over trials of squares.
class PoolOfSquares {
 public:
  void add(double value, std::size_t samples) { sum_ += value * value * static_cast<double>(samples); }
  double rms(std::size_t samples) const { return std::sqrt(sum_ / static_cast<double>(samples)); }

 private:
  double sum_ = 0.0;
};

/// One channel over the trials that are, or are not, held out.
PooledScore pool_channel(const std::vector<TrialComparison>& trials, const std::vector<TrialFloor>& floors,
                         const Channel& channel, bool held_out) {
  PooledScore pooled;
  pooled.channel = channel.name;
  pooled.unit = channel.unit;
  pooled.held_out = held_out;
  PoolOfSquares error, floor, written, numerical;
  double worst = -1.0;
  bool all_numerical = true;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].held_out != held_out || !trials[t].valid) continue;
    for (std::size_t c = 0; c < trials[t].channels.size(); ++c) {
      const ChannelScore& score = trials[t].channels[c];
      if (score.channel != channel.name || score.samples == 0) continue;
      pooled.samples += score.samples;
      error.add(score.rmse, score.samples);
      floor.add(score.floor, score.samples);
      written.add(score.rmse_as_written, score.samples);
      numerical.add(score.numerical.value_or(0.0), score.samples);
      all_numerical = all_numerical && score.numerical.has_value();
      if (score.max_error <= worst) continue;
      worst = score.max_error;
      pooled.worst_trial = trials[t].trial;
      pooled.worst_time = score.max_error_time;
      pooled.floor_origin = floors[t].channels[c].origin;
    }
  }
  if (pooled.samples == 0) return pooled;
  pooled.rmse = error.rms(pooled.samples);
  pooled.floor = floor.rms(pooled.samples);
  pooled.times_floor = pooled.rmse / pooled.floor;
  pooled.rmse_as_written = written.rms(pooled.samples);
  if (all_numerical) pooled.numerical = numerical.rms(pooled.samples);
  return pooled;
}

}  // namespace

double scored_rms(const TimeSeries::Samples& residuals, Eigen::Index channel, Eigen::Index first_scored) {
  double squares = 0.0, count = 0.0;
  for (Eigen::Index row = first_scored; row < residuals.rows(); ++row) {
    const double residual = residuals(row, channel);
    if (!std::isfinite(residual)) continue;
    squares += residual * residual;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares / count) : kNothing;
}

ChannelScore score_channel(const TrialComparison& comparison, Eigen::Index channel, const FloorValue& floor) {
  ChannelScore score;
  score.channel = floor.channel;
  score.unit = floor.unit;
  score.floor = floor.total;
  score.rmse = score.times_floor = score.normalised_rmse = score.bias = score.max_error = score.max_error_time =
      score.rmse_as_written = kNothing;
  if (!comparison.valid) return score;
  std::vector<double> measured;
  double sum = 0.0, largest = -1.0;
  for (Eigen::Index row = comparison.first_scored; row < comparison.residuals.rows(); ++row) {
    const double residual = comparison.residuals(row, channel);
    if (!std::isfinite(residual)) continue;
    measured.push_back(comparison.measured(row, channel));
    sum += residual;
    if (std::abs(residual) <= largest) continue;
    largest = std::abs(residual);
    score.max_error_time = comparison.times(row);
  }
  score.samples = measured.size();
  if (measured.empty()) return score;
  score.rmse = scored_rms(comparison.residuals, channel, comparison.first_scored);
  score.times_floor = score.rmse / score.floor;
  score.normalised_rmse = score.rmse / deviation_of(measured);
  score.bias = sum / static_cast<double>(measured.size());
  score.max_error = largest;
  return score;
}

std::vector<PooledScore> pool(const std::vector<TrialComparison>& trials, const std::vector<TrialFloor>& floors) {
  std::vector<Channel> channels;
  for (const TrialComparison& trial : trials)
    for (const ChannelScore& score : trial.channels) {
      const Channel channel{score.channel, score.unit};
      if (std::find(channels.begin(), channels.end(), channel) == channels.end()) channels.push_back(channel);
    }
  std::vector<PooledScore> all;
  for (const Channel& channel : channels)
    for (const bool held_out : {false, true}) {
      PooledScore pooled = pool_channel(trials, floors, channel, held_out);
      if (pooled.samples > 0) all.push_back(std::move(pooled));
    }
  return all;
}

}  // namespace lacuna
