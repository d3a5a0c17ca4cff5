#pragma once

#include <lacuna/robot_format.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace lacuna::urdf {

/// A frame in another: turned about the fixed x, then y, then z by roll, pitch, yaw.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

  Pose operator*(const Pose& inner) const {
    return {position + orientation * inner.position, orientation * inner.orientation};
  }
};

/// Mass, and the inertia about its centre along the axes of the link.
struct LinkMass {
  double mass = 0.0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

struct Link {
  std::string name;
  int line = 0;
  std::optional<LinkMass> mass;
  std::size_t collisions = 0;
};

enum class JointType { revolute, continuous, prismatic, fixed, floating, planar };

struct Mimic {
  std::string joint;
  double multiplier = 1.0, offset = 0.0;
};

struct Joint {
  std::string name;
  int line = 0;
  JointType type = JointType::fixed;
  std::string parent, child;
  Pose origin;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of unit length, in the joint's frame
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  double effort = 0.0;    ///< N·m or N; 0: none is written
  double velocity = 0.0;  ///< rad/s or m/s; 0: none is written
  double damping = 0.0, friction = 0.0;
  std::optional<Mimic> mimic;
};

/// What stands in a URDF file.
struct File {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<RobotRemark> remarks;
  std::vector<RobotFileProblem> problems;
};

/// Names of links and joints become names of the program: letters, digits, _ and -.
File read_file(const std::string& text);

}  // namespace lacuna::urdf
