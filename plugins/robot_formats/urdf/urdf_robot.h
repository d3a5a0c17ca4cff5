#pragma once

#include "urdf_file.h"

namespace lacuna::urdf {

/// Links that fixed joints hold together become one body, the root the world or, where the base is free, a body that
/// floats on the joint ROOT_free. Every joint that moves and follows no
/// other gets a motor of its name, and each that moves sensors NAME_position and NAME_velocity.
ReadRobot robot_of(const File& file, RobotBase base);

}  // namespace lacuna::urdf
