#pragma once

#include "urdf_file.h"

namespace lacuna::urdf {

/// Puts the numbers that URDF supports into the file from which the robot was read: masses, centres and inertias of
/// links, damping, friction, stops and efforts of joints. Totals of several links are changed at the first of them. A
/// robot from another source gets a new file, without shapes.
WrittenRobot write_urdf(const RobotToWrite& robot);

}  // namespace lacuna::urdf
