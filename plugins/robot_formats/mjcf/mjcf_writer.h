#pragma once

#include "mjcf_file.h"

#include <tinyxml2.h>

namespace lacuna::mjcf {

/// Puts the numbers that an MJCF file has a place for into the file that the robot was read from: masses, centres and
/// inertias of bodies, damping, friction, springs, armatures and stops of joints, and the laws of actuators, which
/// become <general> where they change. Elements without a name stay as they are. A robot that comes from elsewhere gets
/// a file of its own, without geoms.
WrittenRobot write_mjcf(const RobotToWrite& robot);

/// An <inertial> along the principal axes.
void put_inertial(tinyxml2::XMLElement& body, const robot_files::RigidMass& mass);
/// The law of an actuator of a joint that is counted from `reference`, as <general>. False: it has none.
bool put_actuator(tinyxml2::XMLElement& element, const ActuatorSpec& actuator, double reference);

/// Below <mujoco>, which is empty; remarks say what has no place.
void make_file(const RobotSpec& robot, tinyxml2::XMLElement& mujoco, std::vector<RobotRemark>& remarks);

}  // namespace lacuna::mjcf
