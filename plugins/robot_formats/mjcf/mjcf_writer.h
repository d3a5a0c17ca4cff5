#pragma once

#include "mjcf_file.h"

#include <tinyxml2.h>

namespace lacuna::mjcf {

/// Puts the numbers that MJCF supports into the file from which the robot was read: masses, centres and inertias of
/// bodies, damping, friction, springs, armatures and stops of joints, and the laws of actuators, which become <general>
/// where they change. Elements without a name stay as they are. A robot from another source gets a new file, without
/// geoms.
WrittenRobot write_mjcf(const RobotToWrite& robot);

/// An <inertial> along the principal axes.
void put_inertial(tinyxml2::XMLElement& body, const robot_files::RigidMass& mass);
/// The law of an actuator of a joint that is counted from `reference`, as <general>. False: not possible.
bool put_actuator(tinyxml2::XMLElement& element, const ActuatorSpec& actuator, double reference);

/// Below <mujoco>, which is empty; remarks name unsupported content.
void make_file(const RobotSpec& robot, tinyxml2::XMLElement& mujoco, std::vector<RobotRemark>& remarks);

}  // namespace lacuna::mjcf
