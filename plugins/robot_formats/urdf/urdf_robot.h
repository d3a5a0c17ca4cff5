#pragma once

#include "urdf_file.h"

namespace lacuna::urdf {

/// Links that fixed joints hold together become one body, the root the world. Every joint that moves and follows no
/// other gets a motor of its name, and each that moves sensors NAME_position and NAME_velocity.
ReadRobot robot_of(const File& file);

}  // namespace lacuna::urdf
