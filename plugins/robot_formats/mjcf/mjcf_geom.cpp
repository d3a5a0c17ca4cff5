#include "mjcf_geom.h"

#include "inertia_repair.h"

#include <cmath>
#include <numbers>

namespace lacuna::mjcf {
namespace {

using Eigen::Vector3d;
using robot_files::RigidMass;

constexpr double kWater = 1000.0;  ///< kg/m³

/// Radii or half lengths, and the place of the shape.
struct Shape {
  std::string type;
  Vector3d size = Vector3d::Zero();
  Pose pose;
};

/// Volume, m³, and moments of inertia per mass along its own axes, m².
struct Solid {
  double volume = 0.0;
  Vector3d moments = Vector3d::Zero();
};

/// A cylinder of radius r and height h between two hemispheres.
Solid capsule(double r, double h) {
  const double cylinder = std::numbers::pi * r * r * h, ball = 4.0 / 3.0 * std::numbers::pi * r * r * r;
  const double volume = cylinder + ball;
  const double c = cylinder / volume, b = ball / volume;
  const double across = c * (3.0 * r * r + h * h) / 12.0 + b * (0.4 * r * r + h * (3.0 * r + 2.0 * h) / 8.0);
  return {volume, {across, across, 0.5 * c * r * r + 0.4 * b * r * r}};
}

Solid solid_of(const Shape& shape) {
  const double x = shape.size.x(), y = shape.size.y(), z = shape.size.z(), pi = std::numbers::pi;
  if (shape.type == "sphere") return {4.0 / 3.0 * pi * x * x * x, Vector3d::Constant(0.4 * x * x)};
  if (shape.type == "box") return {8.0 * x * y * z, Vector3d(y * y + z * z, x * x + z * z, x * x + y * y) / 3.0};
  if (shape.type == "ellipsoid")
    return {4.0 / 3.0 * pi * x * y * z, Vector3d(y * y + z * z, x * x + z * z, x * x + y * y) / 5.0};
  if (shape.type == "capsule") return capsule(x, 2.0 * y);
  const double h = 2.0 * y, across = (3.0 * x * x + h * h) / 12.0;  // a cylinder
  return {pi * x * x * h, {across, across, 0.5 * x * x}};
}

std::size_t sizes_of(const std::string& type, bool from_to) {
  if (type == "sphere") return 1;
  if (type == "capsule" || type == "cylinder") return from_to ? 1 : 2;
  return from_to ? 2 : 3;
}

/// Between two points, along z.
Pose between(const Attributes& geom, const std::vector<double>& ends, double& half) {
  const Vector3d from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]), along = to - from;
  half = 0.5 * along.stableNorm();
  Pose pose{0.5 * (from + to), Eigen::Quaterniond::Identity()};
  if (!(half > 0.0))
    geom.element().problem("fromto has the same point twice");
  else
    pose.orientation = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), along.stableNormalized());
  return pose;
}

std::optional<Shape> shape_of(const Attributes& geom, const std::string& type, const Settings& settings) {
  Shape shape{type, Vector3d::Zero(), {}};
  const auto ends = type == "sphere" ? std::nullopt : geom.numbers("fromto", 6, 6);
  const std::size_t wanted = sizes_of(type, ends.has_value());
  const auto written = geom.numbers("size", 1, 3);
  if (!written || written->size() < wanted) {
    geom.element().problem(type + "'s size must have " + std::to_string(wanted) + " numbers");
    return std::nullopt;
  }
  for (std::size_t i = 0; i < wanted; ++i) {
    shape.size(static_cast<Eigen::Index>(i)) = written->at(i);
    if (!(written->at(i) > 0.0)) geom.element().problem(type + "'s size must be above 0");
  }
  if (ends)
    shape.pose = between(geom, *ends, shape.size(static_cast<Eigen::Index>(wanted)));
  else
    shape.pose = pose_of(geom, settings);
  return shape;
}

std::string type_of(const Attributes& geom) {
  return geom.text_of("type").value_or(geom.has("mesh") && !geom.has("type") ? "mesh" : "sphere");
}

bool has_solid(const std::string& type) {
  return type == "sphere" || type == "capsule" || type == "cylinder" || type == "box" || type == "ellipsoid";
}

}  // namespace

bool is_mesh(const Attributes& geom) {
  const std::string type = type_of(geom);
  return type == "mesh" || type == "sdf" || geom.has("mesh");
}

std::optional<RigidMass> mass_of_geom(const Attributes& geom, const Settings& settings) {
  const std::string type = type_of(geom);
  const double group = geom.number("group", 0.0);
  if (group < settings.first_group || group > settings.last_group) return std::nullopt;
  if (type == "plane" || type == "hfield") return std::nullopt;
  const double written = geom.number("mass", -1.0);
  if (geom.has("mass") && written < 0.0) geom.element().problem("geom's mass is negative");
  if (is_mesh(geom)) {
    if (!(written > 0.0)) return std::nullopt;
    return RigidMass{written, pose_of(geom, settings).position,
                     robot_files::repaired(Eigen::Matrix3d::Zero(), written)};
  }
  if (!has_solid(type)) {
    geom.element().problem(
        "geom's type \"" + type +
        "\" is unknown; known are sphere, capsule, cylinder, box, ellipsoid, mesh, plane and hfield");
    return std::nullopt;
  }
  const std::optional<Shape> shape = shape_of(geom, type, settings);
  if (!shape) return std::nullopt;
  const Solid solid = solid_of(*shape);
  const double mass = geom.has("mass") ? written : solid.volume * geom.number("density", kWater);
  if (!(mass > 0.0) || !std::isfinite(mass)) return std::nullopt;
  return moved(RigidMass{mass, Vector3d::Zero(), (mass * solid.moments).asDiagonal()}, shape->pose);
}

}  // namespace lacuna::mjcf
