#pragma once

#include "mjcf_defaults.h"
#include "mjcf_settings.h"

#include "element_names.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna::mjcf {

struct Joint {
  std::string name;
  int line = 0;
  std::string file;
  JointKind kind = JointKind::hinge;
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< in the body
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< of unit length, in the body
  double reference = 0.0;                            ///< the file's value where the program's is 0, rad or m
  double lower = -kInfinity, upper = kInfinity;      ///< as the program counts
  double damping = 0.0, dry_friction = 0.0, stiffness = 0.0, rest = 0.0, armature = 0.0;
  double force_limit = kInfinity;  ///< of all actuators together, N·m or N
};

struct Body {
  std::string name;
  int line = 0;
  std::string file;
  std::size_t parent = 0;  ///< index; the world is the first, and its own parent
  Pose pose;               ///< in the parent
  std::vector<Joint> joints;
  std::optional<robot_files::RigidMass> mass;
  std::size_t unread_meshes = 0;  ///< whose mass is to be counted
};

/// A point with axes on a body.
struct Site {
  std::size_t body = 0;
  Pose pose;
};

/// The bodies of an MJCF file. Names are those of the program.
struct File {
  std::string name;
  Settings settings;
  std::vector<Body> bodies;  ///< the world first, each after its parent
  std::map<std::string, Site> sites;
  std::map<std::string, std::size_t> body_of_name;                           ///< as written
  std::map<std::string, std::pair<std::size_t, std::size_t>> joint_of_name;  ///< name as written → body, joint
  robot_files::ElementNames names;
  std::vector<RobotRemark> remarks;
  std::vector<RobotFileProblem>* problems = nullptr;

  void remark(RobotRemarkKind kind, const XmlElement& at, std::string text) {
    remarks.push_back({kind, at.line(), std::move(text), at.file()});
  }
};

/// Reads <worldbody>.
void read_bodies(const Document& document, const DefaultClasses& classes, File& file);

/// One joint of a body.
Joint read_joint(const Attributes& element, const Settings& settings, File& file);

}  // namespace lacuna::mjcf
