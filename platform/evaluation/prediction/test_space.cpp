#include "evaluation/prediction/test_space.h"

#include "foundation/address.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

std::pair<double, double> command_range(const ActuatorSpec& actuator) {
  double lower = actuator.command_lower, upper = actuator.command_upper;
  if (actuator.kind == ActuatorKind::force) {
    lower = std::max(lower, -actuator.force_limit);
    upper = std::min(upper, actuator.force_limit);
  } else if (actuator.kind == ActuatorKind::voltage) {
    const double most = actuator.motor.duty_limit * actuator.motor.supply;
    lower = std::max(lower, -most);
    upper = std::min(upper, most);
  }
  lower = (lower - actuator.offset) / actuator.gain;
  upper = (upper - actuator.offset) / actuator.gain;
  return {std::min(lower, upper), std::max(lower, upper)};
}

/// Smallest and largest sample of a channel over all trials that have it; infinity and minus infinity without one.
std::pair<double, double> commanded(const std::string& actuator, const std::vector<Trial>& trials) {
  double least = kInfinity, most = -kInfinity;
  for (const Trial& trial : trials) {
    const TimeSeries& series = trial.commands.series;
    for (std::size_t c = 0; c < series.channels.size(); ++c)
      if (series.channels[c].name == actuator)
        for (const double value : series.samples.col(static_cast<Eigen::Index>(c))) {
          if (!std::isfinite(value)) continue;
          least = std::min(least, value);
          most = std::max(most, value);
        }
  }
  return {least, most};
}

}  // namespace

TestSpace test_space(const RobotSpec& robot, const EngineSettings& engine, double duration) {
  TestSpace space;
  space.sensors = sensor_channels(robot);
  space.actuators = command_channels(robot);
  space.control_period = engine.control_period > 0.0 ? engine.control_period : engine.step;
  space.duration = duration;
  for (const ActuatorSpec& actuator : robot.actuators) {
    const auto [lower, upper] = command_range(actuator);
    space.lower.push_back(lower);
    space.upper.push_back(upper);
  }
  return space;
}

void limit_to_trials(TestSpace& space, const std::vector<Trial>& trials) {
  for (std::size_t a = 0; a < space.actuators.size(); ++a) {
    const auto [least, most] = commanded(space.actuators[a].name, trials);
    if (least > most) continue;
    if (!std::isfinite(space.lower[a])) space.lower[a] = std::min(least, space.upper[a]);
    if (!std::isfinite(space.upper[a])) space.upper[a] = std::max(most, space.lower[a]);
  }
}

}  // namespace lacuna
