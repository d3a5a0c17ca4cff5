#include "fitting/starts/restarts.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>

namespace lacuna {
namespace {

bool is_driven(const RobotSpec& robot, const Trial& trial, const std::string& joint) {
  return std::ranges::any_of(robot.actuators, [&](const ActuatorSpec& actuator) {
    return actuator.kind == ActuatorKind::force && actuator.joint == joint &&
           std::ranges::any_of(trial.commands.series.channels,
                               [&](const Channel& channel) { return channel.name == actuator.name; });
  });
}

/// Driven joints on the way from a body to the base.
int driven_below(const RobotSpec& robot, const Trial& trial, std::string body) {
  int driven = 0;
  for (std::set<std::string> seen; seen.insert(body).second;) {
    const auto joint = std::ranges::find(robot.joints, body, &JointSpec::child);
    if (joint == robot.joints.end()) break;
    driven += is_driven(robot, trial, joint->name) ? 1 : 0;
    body = joint->parent;
  }
  return driven;
}

}  // namespace

double restart_interval(const RobotSpec& robot, const Trial& trial) {
  const double never = std::numeric_limits<double>::infinity();
  if (trial.closed_loop) return never;
  const bool is_arm = std::ranges::any_of(
      robot.joints, [&](const JointSpec& joint) { return driven_below(robot, trial, joint.child) >= kFewestDriven; });
  return is_arm ? kRestart : never;
}

}  // namespace lacuna
