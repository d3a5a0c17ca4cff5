#pragma once

#include <lacuna/robot_spec.h>

#include <Eigen/Core>

#include <span>

namespace lacuna {

/// Mass, centre of mass and inertia of a rigid body: kg, m in the body frame, kg·m² about the
/// centre of mass along the body's axes.
struct MassProperties {
  double mass = 0.0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// Volume of a solid shape, m³. A capsule's caps are half spheres.
double volume(const ShapeSpec& shape);
/// A homogeneous solid shape of the given mass, placed as the shape is (standard formulae).
MassProperties solid(const ShapeSpec& shape, double mass);
/// Several bodies joined rigidly: the parallel-axis theorem. An empty list has no mass.
MassProperties joined(std::span<const MassProperties> parts);

InertiaSpec to_spec(const Eigen::Matrix3d& inertia);
Eigen::Matrix3d to_matrix(const InertiaSpec& inertia);

/// Principal moments of a real body are positive, and none is larger than the sum of the others.
/// Says which rule is broken, or nothing.
std::string inertia_objection(const InertiaSpec& inertia);

}  // namespace lacuna
