#pragma once

#include "mjcf_file.h"

#include <lacuna/robot_format.h>

namespace lacuna::mjcf {

/// Bodies without joints become parts of the body around them. A body with several joints gets bodies of almost no mass
/// in between. Where the file has no actuator, each hinge and slide gets a motor with its name; where it has no sensor
/// of a joint, NAME_position and NAME_velocity.
ReadRobot read_robot(const RobotText& text);
/// The same, with the contents of the file; its problems go to the result.
ReadRobot read_robot(const RobotText& text, File& file);

}  // namespace lacuna::mjcf
