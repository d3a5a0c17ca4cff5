#pragma once

#include "rigid_mass.h"
#include "urdf_commands.h"

#include <lacuna/robot_format.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace lacuna::urdf {

using robot_files::Pose;
using robot_files::RigidMass;

struct Link {
  std::string name;
  int line = 0;
  std::optional<RigidMass> mass;  ///< along the axes of the link
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
  std::optional<JointCommands> commands;  ///< nothing: the file does not state it
};

/// The contents of a URDF file.
struct File {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  bool says_commands = false;  ///< of any joint
  std::vector<RobotRemark> remarks;
  std::vector<RobotFileProblem> problems;
};

/// Names of links and joints become names of the program: letters, digits, _ and -. A link "world" that moves, such as
/// the root where the base is free, gets another name.
File read_file(const std::string& text, RobotBase base);

}  // namespace lacuna::urdf
