#pragma once

#include <lacuna/robot_spec.h>

#include "config/schema/table.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A robot file as written, before masses are derived and names are resolved. A value's address
/// is where it stands in the file: `body.arm.mass` is `mass` in `[body.arm]`.

struct ShapeInFile {
  ShapeSpec spec;  ///< kind, position and orientation; `size` once resolved
  std::optional<Eigen::Vector3d> size;
  std::optional<double> radius;
  std::optional<double> length;
  std::optional<Eigen::Vector3d> along;
  std::optional<Eigen::Vector3d> rpy;
  std::optional<double> mass;
  std::optional<double> density;
  bool collides = true;
};

struct BodyInFile {
  BodySpec spec;
  std::optional<double> mass;
  std::optional<Eigen::Vector3d> com;
  std::optional<InertiaSpec> inertia;
  std::vector<ShapeInFile> shapes;
};

struct JointInFile {
  JointSpec spec;
  std::optional<Eigen::Vector3d> anchor;
  std::optional<Eigen::Vector3d> axis2;
};

struct SensorInFile {
  SensorSpec spec;
  std::string joint;
  std::string body;
};

struct RobotInFile {
  std::string name;
  Eigen::Vector3d gravity = RobotSpec().gravity;
  std::vector<BodyInFile> bodies;
  std::vector<JointInFile> joints;
  std::vector<ActuatorSpec> actuators;
  std::vector<CouplingSpec> couplings;
  std::vector<SensorInFile> sensors;
  ContactSpec contact;
};

/// Turned about the fixed x, then y, then z by roll, pitch, yaw (rad).
Eigen::Quaterniond orientation_from_rpy(const Eigen::Vector3d& rpy);

/// The shortest turn of z onto a direction; of its opposite, half a turn about x. As Eigen's `FromTwoVectors`, whose
/// decomposition takes longer to compile than all else in this room.
Eigen::Quaterniond orientation_along(const Eigen::Vector3d& direction);

/// The keys of a robot file, each declared once.
Table<RobotInFile> robot_keys();

}  // namespace lacuna
