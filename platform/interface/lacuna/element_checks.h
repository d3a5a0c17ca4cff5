#pragma once

#include <lacuna/error.h>
#include <lacuna/robot_spec.h>

#include <cstddef>

namespace lacuna {

/// For effects that act on a motor's force through its command: the actuator at an index. Throws `Error` for a servo,
/// whose command is a velocity or a position.
inline ActuatorSpec& actuator_of_force(RobotSpec& robot, int actuator) {
  ActuatorSpec& spec = robot.actuators[static_cast<std::size_t>(actuator)];
  if (spec.kind != ActuatorKind::force)
    throw Error("actuator." + spec.name +
                " is a servo, whose command is not a force; place the effect on actuators of kind force");
  return spec;
}

/// For effects that amend the contact of bodies and ground. Throws `Error` for a robot without ground.
inline ContactSpec& contact_with_ground(RobotSpec& robot) {
  if (!robot.contact.ground) throw Error("the robot has no ground; the effect needs contact.ground");
  return robot.contact;
}

}  // namespace lacuna
