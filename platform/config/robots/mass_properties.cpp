#include "config/robots/mass_properties.h"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <numbers>

namespace lacuna {
namespace {

constexpr double kRounding = 1e-9;  // of the triangle inequality: a flat plate fulfils it with equality

Eigen::Vector3d cylinder_moments(double mass, double radius, double length) {
  const double across = mass * (3.0 * radius * radius + length * length) / 12.0;
  return {across, across, 0.5 * mass * radius * radius};
}

/// Along the shape's own axes.
Eigen::Vector3d own_moments(const ShapeSpec& shape, double mass) {
  const Eigen::Vector3d& s = shape.size;
  switch (shape.kind) {
    case ShapeKind::box: {
      const Eigen::Vector3d squares = s.cwiseAbs2();
      return mass / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
    }
    case ShapeKind::sphere: return Eigen::Vector3d::Constant(0.4 * mass * s.x() * s.x());
    case ShapeKind::cylinder: return cylinder_moments(mass, s.x(), s.y());
    case ShapeKind::capsule: break;
  }
  const double radius = s.x();
  const double length = s.y();
  const double tube_volume = std::numbers::pi * radius * radius * length;
  const double tube = mass * tube_volume / volume(shape);
  const double caps = mass - tube;
  // Two half spheres about their common centre line, each moved out from where its flat side meets the tube.
  const double along = 0.4 * caps * radius * radius;
  const double across = along + caps * (0.25 * length * length + 0.375 * length * radius);
  return cylinder_moments(tube, radius, length) + Eigen::Vector3d(across, across, along);
}

Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& at) {
  return mass * (at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose());
}

}  // namespace

double volume(const ShapeSpec& shape) {
  const Eigen::Vector3d& s = shape.size;
  const double disc = std::numbers::pi * s.x() * s.x();
  const double ball = 4.0 / 3.0 * disc * s.x();
  switch (shape.kind) {
    case ShapeKind::box: return s.prod();
    case ShapeKind::sphere: return ball;
    case ShapeKind::cylinder: return disc * s.y();
    case ShapeKind::capsule: return disc * s.y() + ball;
  }
  return 0.0;
}

MassProperties solid(const ShapeSpec& shape, double mass) {
  const Eigen::Matrix3d turn = shape.orientation.toRotationMatrix();
  return {mass, shape.position, turn * own_moments(shape, mass).asDiagonal() * turn.transpose()};
}

MassProperties joined(std::span<const MassProperties> parts) {
  MassProperties whole;
  for (const MassProperties& part : parts) {
    whole.mass += part.mass;
    whole.com += part.mass * part.com;
  }
  if (whole.mass > 0.0) whole.com /= whole.mass;
  for (const MassProperties& part : parts)
    whole.inertia += part.inertia + point_inertia(part.mass, part.com - whole.com);
  return whole;
}

InertiaSpec to_spec(const Eigen::Matrix3d& inertia) {
  return {inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2)};
}

Eigen::Matrix3d to_matrix(const InertiaSpec& inertia) {
  Eigen::Matrix3d matrix;
  matrix << inertia.xx, inertia.xy, inertia.xz, inertia.xy, inertia.yy, inertia.yz, inertia.xz, inertia.yz, inertia.zz;
  return matrix;
}

std::string inertia_objection(const InertiaSpec& inertia) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(to_matrix(inertia), Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& moments = solver.eigenvalues();  // ascending
  const std::string listed = fmt::format("{:.4g}, {:.4g}, {:.4g} kg*m^2", moments[0], moments[1], moments[2]);
  if (!(moments[0] > 0.0))
    return "this inertia is not possible: its principal moments " + listed + " are not all above 0";
  if (moments[2] > (moments[0] + moments[1]) * (1.0 + kRounding))
    return "this inertia is not possible: one of its principal moments " + listed + " exceeds the sum of the others";
  return "";
}

}  // namespace lacuna
