#include "fitting/restarts.h"

#include <algorithm>
#include <limits>

namespace lacuna {

double restart_interval(const RobotSpec& robot, const Trial& trial) {
  const double never = std::numeric_limits<double>::infinity();
  if (trial.closed_loop) return never;
  int driven = 0;
  for (const ActuatorSpec& actuator : robot.actuators) {
    const bool is_commanded = std::ranges::any_of(
        trial.commands.series.channels, [&](const Channel& channel) { return channel.name == actuator.name; });
    if (actuator.kind == ActuatorKind::force && is_commanded) ++driven;
  }
  return driven >= kFewestDriven ? kRestart : never;
}

}  // namespace lacuna
