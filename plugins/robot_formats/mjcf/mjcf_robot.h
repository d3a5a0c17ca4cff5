#pragma once

#include "mjcf_file.h"

#include <lacuna/robot_format.h>

namespace lacuna::mjcf {

/// Bodies without joints are parts of what they stand in. A body with several joints gets bodies of next to no mass in
/// between. Where the file has no actuator, each hinge and slide gets a motor of its name; where it has no sensor of a
/// joint, NAME_position and NAME_velocity.
ReadRobot read_robot(const RobotText& text);
/// The same, and what stands in the file; its problems are those of the result, and end with it.
ReadRobot read_robot(const RobotText& text, File& file);

}  // namespace lacuna::mjcf
