#include "urdf_elements.h"

#include "xml_writing.h"

#include <algorithm>
#include <cmath>

namespace lacuna::urdf {
namespace {

using robot_files::child_of;
using robot_files::number_text;
using robot_files::vector_text;
using tinyxml2::XMLElement;

void put(XMLElement& element, const char* attribute, double value) {
  element.SetAttribute(attribute, number_text(value).c_str());
}

}  // namespace

void put_inertial(XMLElement& link, const RigidMass& mass) {
  XMLElement& inertial = child_of(link, "inertial");
  XMLElement& origin = child_of(inertial, "origin");
  origin.SetAttribute("xyz", vector_text(mass.com).c_str());
  origin.SetAttribute("rpy", "0 0 0");
  put(child_of(inertial, "mass"), "value", mass.mass);
  XMLElement& inertia = child_of(inertial, "inertia");
  const char* names[] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
  const double values[] = {mass.inertia(0, 0), mass.inertia(0, 1), mass.inertia(0, 2),
                           mass.inertia(1, 1), mass.inertia(1, 2), mass.inertia(2, 2)};
  for (std::size_t i = 0; i < 6; ++i) put(inertia, names[i], values[i]);
}

/// Limits of a hinge or slider; a URDF needs an effort and a velocity with them.
void put_limits(XMLElement& joint, const JointSpec& spec, double effort) {
  if (!std::isfinite(effort) && !std::isfinite(spec.lower) && !joint.FirstChildElement("limit")) return;
  XMLElement& limit = child_of(joint, "limit");
  if (std::isfinite(effort)) put(limit, "effort", effort);
  if (std::isfinite(spec.lower) && std::isfinite(spec.upper)) {
    put(limit, "lower", spec.lower);
    put(limit, "upper", spec.upper);
  }
  for (const char* needed : {"effort", "velocity"})
    if (!limit.Attribute(needed)) limit.SetAttribute(needed, "0");
}

void put_dynamics(XMLElement& joint, const JointSpec& spec) {
  if (spec.damping == 0.0 && spec.dry_friction == 0.0 && !joint.FirstChildElement("dynamics")) return;
  XMLElement& dynamics = child_of(joint, "dynamics");
  put(dynamics, "damping", spec.damping);
  put(dynamics, "friction", spec.dry_friction);
}

double effort_of(const RobotSpec& robot, const std::string& joint) {
  for (const ActuatorSpec& actuator : robot.actuators)
    if (actuator.joint == joint) return actuator.force_limit;
  return kInfinity;
}

const BodySpec* body_called(const RobotSpec& robot, const std::string& name) {
  const auto found =
      std::find_if(robot.bodies.begin(), robot.bodies.end(), [&](const BodySpec& one) { return one.name == name; });
  return found == robot.bodies.end() ? nullptr : &*found;
}

}  // namespace lacuna::urdf
