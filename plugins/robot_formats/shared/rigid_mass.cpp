#include "rigid_mass.h"

#include <cmath>

namespace lacuna::robot_files {

Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& away) {
  return mass * (away.squaredNorm() * Eigen::Matrix3d::Identity() - away * away.transpose());
}

RigidMass joined(const std::vector<RigidMass>& parts) {
  if (parts.size() == 1) return parts.front();  // to the last digit
  RigidMass whole;
  for (const RigidMass& part : parts) {
    whole.mass += part.mass;
    whole.com += part.mass * part.com;
  }
  if (whole.mass > 0.0) whole.com /= whole.mass;
  for (const RigidMass& part : parts) whole.inertia += part.inertia + point_inertia(part.mass, part.com - whole.com);
  return whole;
}

RigidMass without(const RigidMass& whole, const RigidMass& part) {
  RigidMass rest;
  rest.mass = whole.mass - part.mass;
  rest.com = (whole.mass * whole.com - part.mass * part.com) / rest.mass;
  rest.inertia = whole.inertia - part.inertia - point_inertia(part.mass, part.com - whole.com) -
                 point_inertia(rest.mass, rest.com - whole.com);
  return rest;
}

RigidMass moved(const RigidMass& mass, const Pose& pose) {
  const Eigen::Matrix3d turn = pose.orientation.toRotationMatrix();
  return {mass.mass, pose.position + pose.orientation * mass.com, turn * mass.inertia * turn.transpose()};
}

InertiaSpec spec_of(const Eigen::Matrix3d& inertia) {
  return {inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2)};
}

Eigen::Matrix3d matrix_of(const InertiaSpec& inertia) {
  Eigen::Matrix3d matrix;
  matrix << inertia.xx, inertia.xy, inertia.xz, inertia.xy, inertia.yy, inertia.yz, inertia.xz, inertia.yz, inertia.zz;
  return matrix;
}

BodySpec body_of(const std::string& name, const RigidMass& mass, const Pose& pose) {
  BodySpec body;
  body.name = name;
  body.mass = mass.mass;
  body.com = mass.com;
  body.inertia = spec_of(mass.inertia);
  body.position = pose.position;
  body.orientation = pose.orientation;
  return body;
}

std::string why_too_large(const BodySpec& body) {
  const bool is_finite = std::isfinite(body.mass) && matrix_of(body.inertia).allFinite() && body.com.allFinite() &&
                         body.position.allFinite() && body.orientation.coeffs().allFinite();
  if (is_finite) return {};
  return "the mass, inertia or position of " + body.name +
         " is too large to compute with; check the exponents of its numbers and of those of the parts fixed to it";
}

}  // namespace lacuna::robot_files
