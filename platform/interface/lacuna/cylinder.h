#pragma once

#include <lacuna/robot_spec.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

/// Functions shared by robots of cylinders, and of capsules where stated.

/// Moments of inertia of a solid cylinder along x about its centre; mass in kg, radius and length in m.
inline InertiaSpec solid_cylinder(double mass, double radius, double length) {
  const double along = 0.5 * mass * radius * radius;
  const double across = mass * (3.0 * radius * radius + length * length) / 12.0;
  return {.xx = along, .yy = across, .zz = across};
}

/// The ends of a body's cylinder, or of a capsule without its caps; world frame, m.
struct CylinderEnds {
  Eigen::Vector3d tail;  ///< in the direction of the shape's −z
  Eigen::Vector3d head;
};

inline CylinderEnds cylinder_ends(const BodySpec& body, const ShapeSpec& shape) {
  const Eigen::Vector3d centre = body.position + body.orientation * shape.position;
  const Eigen::Vector3d half = body.orientation * (shape.orientation * Eigen::Vector3d(0.0, 0.0, 0.5 * shape.size.y()));
  return {centre - half, centre + half};
}

/// Height of the lowest point of a body's cylinder, m.
inline double lowest_point(const BodySpec& body, const ShapeSpec& cylinder) {
  const double slope = (body.orientation * (cylinder.orientation * Eigen::Vector3d::UnitZ())).z();
  const double centre = (body.position + body.orientation * cylinder.position).z();
  return centre - 0.5 * cylinder.size.y() * std::abs(slope) -
         cylinder.size.x() * std::sqrt(std::max(0.0, 1.0 - slope * slope));
}

}  // namespace lacuna
