#pragma once

#include "urdf_file.h"

namespace lacuna::urdf {

/// Puts the numbers that a URDF has a place for into the file that the robot was read from: masses, centres and
/// inertias of links, damping, friction, stops and efforts of joints. What several links have together is changed at
/// the first of them. A robot that comes from elsewhere gets a file of its own, without shapes.
WrittenRobot write_urdf(const RobotToWrite& robot);

}  // namespace lacuna::urdf
