#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/shared/joint_tree.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <span>
#include <vector>

namespace lacuna::articulated {

/// The index of the `i`th element of a range that begins at `first`.
inline std::size_t nth(int first, int i) { return static_cast<std::size_t>(first) + static_cast<std::size_t>(i); }

/// Motion of a link relative to its parent. `floating`: no joint holds it, but a free one may give it coordinates.
enum class LinkKind { hinge, slider, universal, ball, fixed, floating };

/// A body and its joint. All values are those of the zero configuration, in the world's axes.
struct Link {
  LinkKind kind = LinkKind::fixed;
  int body = 0;      ///< index into the robot's
  int parent = -1;   ///< link; −1: the world
  int root = 0;      ///< the link of this tree that has no parent
  int dof = 0;       ///< the first of its velocities
  int dofs = 0;      ///< 1, 1, 2, 3, 0, 6
  int position = 0;  ///< the first of its numbers in a configuration
  Eigen::Vector3d anchor{0.0, 0.0, 0.0};
  std::array<Eigen::Vector3d, 2> axes;
  Eigen::Matrix3d parent_frame = Eigen::Matrix3d::Identity();       ///< parent to world
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of the body's frame
  double mass = 0.0;
  Eigen::Vector3d com{0.0, 0.0, 0.0};
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre of mass
};

/// A robot's links, each after its parent, and the coordinates of their motion.
///
/// A configuration holds for each link: hinge and slider the coordinate, universal both; ball the unit quaternion (w,
/// x, y, z) of its rotation in the parent's frame; floating the centre of mass in the world and the unit quaternion of
/// the rotation from the zero pose. The velocities: of the coordinates; ball the angular velocity relative to the
/// parent, in the parent's frame; floating that of the centre of mass, then the angular velocity, both in the world.
class Tree {
 public:
  Tree(const RobotSpec& robot, const simulation::JointTree& joints);

  /// Updates the numbers from a robot of the same structure.
  void set(const RobotSpec& robot);

  const std::vector<Link>& links() const { return links_; }
  std::size_t dofs() const { return dofs_; }
  std::size_t positions() const { return positions_; }
  std::size_t link_of_body(std::size_t body) const { return link_of_body_[body]; }
  /// The velocity of each joint coordinate.
  std::span<const std::size_t> dof_of_coordinate() const { return dof_of_coordinate_; }

  /// The configuration `time` later at constant velocities.
  void drift(std::span<const double> velocities, double time, std::span<double> configuration) const;

  /// The configuration and velocities of joint coordinates (empty: zero), with floating bodies at their zero pose.
  void begin(const RobotSpec& robot, std::span<const double> coordinates, std::span<const double> rates,
             std::span<double> configuration, std::span<double> velocities) const;
  /// Joint coordinates of a configuration.
  void coordinates(std::span<const double> configuration, std::span<double> out) const;

 private:
  std::vector<Link> links_;
  std::vector<int> joint_of_link_;  ///< −1: floating
  std::vector<std::size_t> link_of_body_, dof_of_coordinate_;
  std::size_t dofs_ = 0, positions_ = 0;
};

}  // namespace lacuna::articulated
