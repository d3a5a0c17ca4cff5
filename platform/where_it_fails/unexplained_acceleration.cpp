#include "where_it_fails/unexplained_acceleration.h"

#include "where_it_fails/residual_view.h"
#include "foundation/address.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

constexpr std::array kWindows = {0.1, 0.2, 0.4};  // s
constexpr double kClearlySeen = 3.0;              // least ratio of an acceleration to the deviation of its noise
constexpr double kCloseState = 0.1;  // error of a free run over the motion: below it the model's state counts as true
constexpr Eigen::Index kFewestHalf = 4;  // samples on either side
constexpr double kNotTold = std::numeric_limits<double>::quiet_NaN();

/// How often the residual of a channel must be differentiated for an acceleration; 0: the channel gives none.
int order_of(const RobotSpec& robot, const Channel& channel) {
  for (const SensorSpec& sensor : robot.sensors) {
    const std::vector<Channel> channels = sensor_channels(robot, sensor);
    if (std::find(channels.begin(), channels.end(), channel) == channels.end()) continue;
    switch (sensor.kind) {
      case SensorKind::joint_position:
      case SensorKind::body_position: return 2;
      case SensorKind::joint_velocity:
      case SensorKind::body_velocity:
      case SensorKind::body_angular_velocity: return 1;
      default: return 0;
    }
  }
  return 0;
}

constexpr double kLongestKept = 0.5;  ///< s of prediction after which a model's state is too far from the robot's

/// 0, free runs, where these stay close to what was measured; else the longest horizon, not chosen by the data, that
/// every trial of the table has and that is not too long, or 0.
double horizon_for(const Comparison& comparison, const FeatureTable& table) {
  const bool close = std::all_of(comparison.trials.begin(), comparison.trials.end(), [](const TrialComparison& trial) {
    return trial.held_out || !trial.valid ||
           std::all_of(trial.channels.begin(), trial.channels.end(), [](const ChannelScore& score) {
             return score.samples == 0 || score.normalised_rmse < kCloseState || score.times_floor < kClearlySeen;
           });
  });
  if (close) return 0.0;
  double longest = std::numeric_limits<double>::infinity();
  for (const std::size_t t : table.trial) {
    double own = 0.0;
    for (const HorizonScore& score : comparison.trials[t].horizons)
      if (!score.automatic && score.horizon <= kLongestKept) own = std::max(own, score.horizon);
    longest = std::min(longest, own);
  }
  return std::isfinite(longest) ? longest : 0.0;
}

/// The derivative at its middle of a polynomial through the residual.
struct Local {
  double value = kNotTold, slope = kNotTold, acceleration = kNotTold;
  double gain = kNotTold;  ///< deviation of the acceleration over that of a sample
};

/// `order`: 2, a parabola, or 1, a line. Samples that are not finite are left out.
Local local(const Eigen::VectorXd& times, const Eigen::VectorXd& residual, Eigen::Index first, Eigen::Index last,
            Eigen::Index middle, int order) {
  const double half = 0.5 * (times(last) - times(first));
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  Eigen::Index points = 0;
  for (Eigen::Index i = first; i <= last; ++i) {
    if (!std::isfinite(residual(i))) continue;
    const double x = (times(i) - times(middle)) / half;
    const Eigen::Vector3d powers(1.0, x, x * x);
    gram += powers * powers.transpose();
    sums += residual(i) * powers;
    ++points;
  }
  if (points < 2 * kFewestHalf) return {};
  const int terms = order + 1;
  const Eigen::MatrixXd inverse =
      gram.topLeftCorner(terms, terms).ldlt().solve(Eigen::MatrixXd::Identity(terms, terms));
  const Eigen::VectorXd fit = inverse * sums.head(terms);
  const double scale = order == 2 ? 2.0 / (half * half) : 1.0 / half;
  return {fit(0), fit(1) / half, scale * fit(order), scale * std::sqrt(inverse(order, order))};
}

/// The residual of a trial's channel, and where its stretches begin.
struct AccelerationSource {
  const TrialComparison* trial = nullptr;
  Eigen::VectorXd residual;
  std::vector<Eigen::Index> starts;  ///< ascending; contains the first sample and one past the last

  Local at(Eigen::Index sample, int order, double window) const {
    const auto next = std::upper_bound(starts.begin(), starts.end(), sample);
    if (next == starts.begin() || next == starts.end()) return {};
    const Eigen::VectorXd& times = trial->times;
    const Eigen::Index begin = *(next - 1), end = *next - 1;
    Eigen::Index first = sample, last = sample;
    while (first > begin && (sample - first < kFewestHalf || times(sample) - times(first - 1) <= 0.5 * window)) --first;
    while (last < end && (last - sample < kFewestHalf || times(last + 1) - times(sample) <= 0.5 * window)) ++last;
    // Only for windows inside the stretch: at an end the estimate is poor.
    const Eigen::Index reach = std::min(sample - first, last - sample);
    if (reach < kFewestHalf || 2 * reach < std::max(sample - first, last - sample)) return {};
    return local(times, residual, first, last, sample, order);
  }
};

AccelerationSource source_of(const TrialComparison& trial, std::size_t channel, double horizon) {
  const auto column = static_cast<Eigen::Index>(channel);
  if (horizon == 0.0) return {&trial, trial.residuals.col(column), {trial.first_scored, trial.residuals.rows()}};
  for (const HorizonScore& score : trial.horizons) {
    if (score.horizon != horizon) continue;
    AccelerationSource source{&trial, score.residuals.col(column), score.restarts};
    source.starts.push_back(score.residuals.rows());
    return source;
  }
  return {};
}

UnexplainedAcceleration of_channel(const Comparison& comparison, const FeatureTable& table, const Channel& channel,
                                   int order, double horizon, double window) {
  const auto rows = static_cast<Eigen::Index>(table.trial.size());
  UnexplainedAcceleration result{{channel.name, channel.unit + (order == 2 ? "/s^2" : "/s")},
                                 Eigen::VectorXd::Constant(rows, kNotTold),
                                 Eigen::VectorXd::Constant(rows, kNotTold),
                                 Eigen::MatrixXd::Constant(rows, order, kNotTold)};
  if (order == 1 && channel.unit.ends_with("/s")) result.channel.unit = channel.unit + "^2";
  AccelerationSource source;
  double floor = kNotTold;
  for (Eigen::Index row = 0; row < rows; ++row) {
    const TrialComparison& trial = comparison.trials[table.trial[static_cast<std::size_t>(row)]];
    if (source.trial != &trial) {
      const auto found = std::find_if(trial.channels.begin(), trial.channels.end(),
                                      [&](const ChannelScore& score) { return score.channel == channel.name; });
      source = {&trial, {}, {}};
      if (found == trial.channels.end()) continue;
      const auto index = static_cast<std::size_t>(found - trial.channels.begin());
      source = source_of(trial, index, horizon);
      const std::size_t t = table.trial[static_cast<std::size_t>(row)];
      floor = comparison.floors[t].channels[index].sensor;
    }
    if (source.starts.empty()) continue;
    const Local here = source.at(table.sample[static_cast<std::size_t>(row)], order, window);
    result.values(row) = here.acceleration;
    result.deviations(row) = here.gain * floor;
    result.own_error(row, 0) = here.value;
    if (order == 2) result.own_error(row, 1) = here.slope;
  }
  return result;
}

/// RMS over its rows, in deviations of the noise.
double clearness(const UnexplainedAcceleration& one) {
  double squares = 0.0, count = 0.0;
  for (Eigen::Index row = 0; row < one.values.size(); ++row)
    if (std::isfinite(one.values(row))) {
      squares += std::pow(one.values(row) / one.deviations(row), 2);
      count += 1.0;
    }
  return std::sqrt(squares / count);
}

}  // namespace

Accelerations unexplained_accelerations(const RobotSpec& robot, const Comparison& comparison,
                                        const FeatureTable& table) {
  Accelerations result;
  result.horizon = horizon_for(comparison, table);
  for (const Channel& channel : channels_of(comparison)) {
    const int order = order_of(robot, channel);
    if (order == 0) continue;
    std::optional<UnexplainedAcceleration> chosen;
    for (const double window : kWindows) {
      UnexplainedAcceleration one = of_channel(comparison, table, channel, order, result.horizon, window);
      const double clear = clearness(one);
      if (std::isfinite(clear)) chosen = std::move(one);
      if (clear >= kClearlySeen) break;
    }
    if (chosen) result.channels.push_back(std::move(*chosen));
  }
  return result;
}

}  // namespace lacuna
