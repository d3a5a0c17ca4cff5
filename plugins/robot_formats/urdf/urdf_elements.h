#pragma once

#include "urdf_file.h"

#include <tinyxml2.h>

namespace lacuna::urdf {

/// The <inertial> of a link; numbers read back as the same numbers.
void put_inertial(tinyxml2::XMLElement& link, const RigidMass& mass);
/// Stops of a hinge or slider, where it has both, and its effort; a URDF needs an effort and a velocity beside stops.
void put_limits(tinyxml2::XMLElement& joint, const JointSpec& spec, double effort);
/// Damping and friction.
void put_dynamics(tinyxml2::XMLElement& joint, const JointSpec& spec);

/// Of the motor of a joint; infinite without one.
double effort_of(const RobotSpec& robot, const std::string& joint);
/// Null: there is none.
const BodySpec* body_called(const RobotSpec& robot, const std::string& name);

/// Below <robot>, which is empty; remarks name unsupported content.
void make_file(const RobotSpec& robot, tinyxml2::XMLElement& root, std::vector<RobotRemark>& remarks);

}  // namespace lacuna::urdf
