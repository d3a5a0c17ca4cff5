#pragma once

#include <lacuna/robot_spec.h>

#include <string>
#include <vector>

namespace lacuna {

/// Everything that keeps a robot from being compiled, a sentence each: names that are missing, cannot be part of an
/// address, are taken twice or lead nowhere; a body with two parents, a circle of joints; actuators and sensors on
/// joints that cannot have them; axes and quaternions that are no unit vectors; values that are not numbers or outside
/// their physical bounds, shapes without size, inertia that no body can have. Empty: `compile` takes the robot.
std::vector<std::string> robot_problems(const RobotSpec& robot);

}  // namespace lacuna
