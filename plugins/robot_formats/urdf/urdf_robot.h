#pragma once

#include "urdf_file.h"

namespace lacuna::urdf {

/// Links connected by fixed joints become one body, the root the world or, where the base is free, a body that floats
/// on the joint ROOT_free. Every moving joint that follows no other gets a motor with its name, and every moving joint
/// gets sensors NAME_position and NAME_velocity.
ReadRobot robot_of(const File& file, RobotBase base);

}  // namespace lacuna::urdf
