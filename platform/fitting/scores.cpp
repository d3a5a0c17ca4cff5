#include "fitting/scores.h"

#include "fitting/numerics/scored_rms.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kNotScored = std::numeric_limits<double>::quiet_NaN();

double deviation_of(const std::vector<double>& values) {
  double mean = 0.0, squares = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// The measured values of a channel that are to be scored.
std::vector<double> measured_values(const TrialComparison& comparison, Eigen::Index channel) {
  std::vector<double> values;
  for (Eigen::Index row = comparison.first_scored; row < comparison.measured.rows(); ++row)
    if (std::isfinite(comparison.measured(row, channel))) values.push_back(comparison.measured(row, channel));
  return values;
}

/// Weighted sums over trials of squares.
class PoolOfSquares {
 public:
  void add(double value, std::size_t samples) { sum_ += value * value * static_cast<double>(samples); }
  /// NaN over no samples.
  double rms(std::size_t samples) const { return std::sqrt(sum_ / static_cast<double>(samples)); }

 private:
  double sum_ = 0.0;
};

/// One channel over the trials that are, or are not, held out.
class ChannelPool {
 public:
  ChannelPool(const Channel& channel, bool held_out) {
    pooled_.channel = channel.name;
    pooled_.unit = channel.unit;
    pooled_.held_out = held_out;
  }

  void add(const TrialComparison& trial, const ChannelScore& score, const std::string& floor_origin) {
    to_score_ += score.samples;
    written_.add(score.rmse_as_written, score.samples);
    if (!trial.valid) {
      ++pooled_.failed_trials;
      return;
    }
    pooled_.samples += score.samples;
    error_.add(score.rmse, score.samples);
    floor_.add(score.floor, score.samples);
    start_.add(score.from_start, score.samples);
    numerical_.add(score.numerical.value_or(0.0), score.samples);
    all_numerical_ = all_numerical_ && score.numerical.has_value();
    if (std::isnan(score.floor)) unknown_floor_ = floor_origin;
    if (score.max_error <= worst_) return;
    worst_ = score.max_error;
    pooled_.worst_trial = trial.trial;
    pooled_.worst_time = score.max_error_time;
    pooled_.floor_origin = floor_origin;
  }

  bool empty() const { return to_score_ == 0; }

  PooledScore score() const {
    PooledScore pooled = pooled_;
    pooled.rmse = pooled.failed_trials > 0 ? kNotScored : error_.rms(pooled.samples);
    pooled.floor = floor_.rms(pooled.samples);
    pooled.times_floor = pooled.rmse / pooled.floor;
    pooled.from_start = start_.rms(pooled.samples);
    pooled.rmse_as_written = written_.rms(to_score_);
    if (all_numerical_ && pooled.samples > 0) pooled.numerical = numerical_.rms(pooled.samples);
    if (!unknown_floor_.empty()) pooled.floor_origin = unknown_floor_;
    return pooled;
  }

 private:
  PooledScore pooled_;
  PoolOfSquares error_, floor_, start_, written_, numerical_;
  std::size_t to_score_ = 0;
  double worst_ = -1.0;
  bool all_numerical_ = true;
  std::string unknown_floor_;  ///< why the floor is not known
};

ChannelPool pool_channel(const std::vector<TrialComparison>& trials, const std::vector<TrialFloor>& floors,
                         const Channel& channel, bool held_out) {
  ChannelPool pool(channel, held_out);
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].held_out != held_out) continue;
    for (std::size_t c = 0; c < trials[t].channels.size(); ++c) {
      const ChannelScore& score = trials[t].channels[c];
      if (score.channel == channel.name && score.samples > 0) pool.add(trials[t], score, floors[t].channels[c].origin);
    }
  }
  return pool;
}

}  // namespace

ChannelScore score_channel(const TrialComparison& comparison, Eigen::Index channel, const FloorValue& floor) {
  ChannelScore score;
  score.channel = floor.channel;
  score.unit = floor.unit;
  score.floor = floor.total;
  score.rmse = score.times_floor = score.normalised_rmse = score.bias = score.max_error = score.max_error_time =
      score.rmse_as_written = kNotScored;
  const std::vector<double> measured = measured_values(comparison, channel);
  score.samples = measured.size();
  if (measured.empty() || !comparison.valid) return score;
  double sum = 0.0, largest = -1.0;
  for (Eigen::Index row = comparison.first_scored; row < comparison.residuals.rows(); ++row) {
    const double residual = comparison.residuals(row, channel);
    if (!std::isfinite(residual)) continue;
    sum += residual;
    if (std::abs(residual) <= largest) continue;
    largest = std::abs(residual);
    score.max_error_time = comparison.times(row);
  }
  score.rmse = scored_rms(comparison.residuals, channel, comparison.first_scored);
  score.times_floor = score.rmse / score.floor;
  score.normalised_rmse = score.rmse / deviation_of(measured);
  score.bias = sum / static_cast<double>(measured.size());
  score.parts =
      error_parts(comparison.measured.col(channel).tail(comparison.measured.rows() - comparison.first_scored),
                  comparison.predicted.col(channel).tail(comparison.predicted.rows() - comparison.first_scored));
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
      const ChannelPool pool = pool_channel(trials, floors, channel, held_out);
      if (!pool.empty()) all.push_back(pool.score());
    }
  return all;
}

}  // namespace lacuna
