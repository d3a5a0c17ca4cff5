#include "evaluation/robots/joint_drives.h"

#include "foundation/address.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kUsualForce = 10.0;  ///< N*m or N
constexpr double kUsualError = 0.1;   ///< rad or m
constexpr double kUsualTime = 0.1;    ///< kd over kp, s

}  // namespace

void set_drive(ActuatorSpec& actuator, ActuatorKind kind) {
  if (actuator.kind == kind) return;
  ActuatorSpec changed;
  changed.name = actuator.name;
  changed.joint = actuator.joint;
  changed.kind = kind;
  changed.delay = actuator.delay;
  changed.force_limit = actuator.force_limit;
  changed.transmission = actuator.transmission;
  const double stiffness = (std::isfinite(actuator.force_limit) ? actuator.force_limit : kUsualForce) / kUsualError;
  if (kind == ActuatorKind::position_servo) changed.kp = stiffness;
  if (kind != ActuatorKind::force) changed.kd = kUsualTime * stiffness;
  actuator = changed;
}

void set_drives(RobotSpec& robot, const Experiment& experiment, const ModelSection& section, const std::string& key,
                ProblemList& problems) {
  for (const auto& [pattern, kind] : section.drive) {
    bool found = false;
    for (ActuatorSpec& actuator : robot.actuators) {
      if (!matches(pattern, "actuator." + actuator.name)) continue;
      set_drive(actuator, kind);
      found = true;
    }
    if (!found)
      problems.add(experiment.where(key + ".actuator_kinds"),
                   fmt::format("the robot has no actuator \"{}\"; write one such as \"actuator.{}\"", pattern,
                               robot.actuators.empty() ? "NAME" : robot.actuators.front().name));
  }
}

}  // namespace lacuna
