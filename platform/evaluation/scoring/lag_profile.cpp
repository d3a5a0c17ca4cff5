#include "evaluation/scoring/lag_profile.h"

#include "foundation/address.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr int kRefinements = 24;  // halvings of the interval around the best whole step

/// Readings of a sensor with the delay `delay`, row by row: linear between two readings, like the engine.
class DelayedReadings {
 public:
  DelayedReadings(const Eigen::VectorXd& times, double delay) : times_(times), delay_(delay) {}

  double at(const TimeSeries::Samples& readings, Eigen::Index row, Eigen::Index channel) {
    const double time = times_(row) - delay_;
    while (before_ + 1 < row && times_(before_ + 1) <= time) ++before_;
    if (delay_ == 0.0 || row == 0) return readings(row, channel);
    if (time <= times_(0)) return readings(0, channel);
    const double share = (time - times_(before_)) / (times_(before_ + 1) - times_(before_));
    return readings(before_, channel) + share * (readings(before_ + 1, channel) - readings(before_, channel));
  }

 private:
  const Eigen::VectorXd& times_;
  double delay_;
  Eigen::Index before_ = 0;  // rows come in order
};

/// The channels of a sensor in a trial, as indices into the measured channels.
std::vector<Eigen::Index> measured_channels(const RobotSpec& robot, const std::string& address, const Trial& trial) {
  std::vector<Eigen::Index> measured;
  for (const SensorSpec& sensor : robot.sensors) {
    if ("sensor." + sensor.name + ".delay" != address) continue;
    const std::vector<Channel> channels = sensor_channels(robot, sensor);
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c)
      for (const Channel& channel : channels)
        if (channel.name == trial.measured.channels[c].name) measured.push_back(static_cast<Eigen::Index>(c));
  }
  return measured;
}

}  // namespace

LagProfile::LagProfile(const ModelDefinition& model, const std::vector<std::size_t>& delays,
                       const std::vector<ScoredTrial>& trials)
    : trials_(&trials), step_(model.engine.step), whole_steps_(model.engine.delay_rounding == DelayRounding::step) {
  if (trials.empty()) return;
  for (const std::size_t value : delays)
    lags_.push_back({value, measured_channels(model.structure.robot, model.free[value].address, trials.front().trial),
                     model.free[value].upper});
}

double LagProfile::difference(const Lag& lag, const TrialReadings& readings, double delay) const {
  double sum = 0.0;
  for (std::size_t t = 0; t < readings.size(); ++t) {
    const ScoredTrial& scored = (*trials_)[t];
    for (const Eigen::Index channel : lag.channels) {
      DelayedReadings delayed(scored.trial.measured.times, delay);
      for (Eigen::Index row = scored.first_sample; row < readings[t].rows(); ++row) {
        const double measured = scored.trial.measured.samples(row, channel);
        const double predicted = delayed.at(readings[t], row, channel);
        if (!std::isnan(measured)) sum += std::abs(measured - predicted);
      }
    }
  }
  return sum;
}

double LagProfile::best_delay(const Lag& lag, const TrialReadings& readings) const {
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  const auto steps = static_cast<int>(std::floor(lag.longest / step_ + 1e-9));
  for (int k = 0; k <= steps; ++k)
    if (const double sum = difference(lag, readings, k * step_); sum < least) {
      least = sum;
      best = k * step_;
    }
  if (whole_steps_) return best;
  double width = step_;
  for (int refinement = 0; refinement < kRefinements; ++refinement) {
    width *= 0.5;
    const double centre = best;
    for (const double delay : {centre - width, centre + width})
      if (delay >= 0.0 && delay <= lag.longest)
        if (const double sum = difference(lag, readings, delay); sum < least) {
          least = sum;
          best = delay;
        }
  }
  return best;
}

void LagProfile::fit(TrialReadings& readings, std::span<double> values) const {
  for (const Lag& lag : lags_) {
    const double delay = best_delay(lag, readings);
    values[lag.value] = delay;
    for (std::size_t t = 0; t < readings.size(); ++t)
      for (const Eigen::Index channel : lag.channels) {
        DelayedReadings delayed((*trials_)[t].trial.measured.times, delay);
        Eigen::VectorXd shifted(readings[t].rows());
        for (Eigen::Index row = 0; row < readings[t].rows(); ++row)
          shifted(row) = delayed.at(readings[t], row, channel);
        readings[t].col(channel) = shifted;
      }
  }
}

}  // namespace lacuna
