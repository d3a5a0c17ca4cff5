#pragma once

#include <lacuna/robot_spec.h>

#include <string>
#include <vector>

namespace lacuna {

/// Everything that prevents a robot from being compiled, one sentence each: missing, repeated, invalid or unknown
/// names; a body with two parents, a cycle of joints; actuators and sensors on joints that cannot have them; axes and
/// quaternions that are not unit vectors; values that are not numbers or outside their physical bounds, shapes without
/// size, impossible inertia. Empty: `compile` accepts the robot.
std::vector<std::string> robot_problems(const RobotSpec& robot);

}  // namespace lacuna
