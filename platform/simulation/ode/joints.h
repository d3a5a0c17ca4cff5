#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/bodies.h"
#include "simulation/shared/joint_tree.h"

#include <ode/ode.h>

#include <span>
#include <vector>

namespace lacuna::ode {

/// The ideal joints of a robot and their coordinates. ODE's joint angles wrap and change their sign with the order of
/// attachment, so the coordinates are computed here from the bodies; positive is child relative to parent for all of
/// them.
class Joints {
 public:
  explicit Joints(const simulation::JointTree& tree);

  /// Creates the joints of a robot whose bodies are at their zero poses.
  void create(dWorldID world, const RobotSpec& robot, const Bodies& bodies);
  void destroy();

  /// Computes coordinates, velocities and axes from the bodies. Turns continue from the last coordinates;
  /// `set_positions` gives the first ones.
  void update();
  void set_positions(std::span<const double> positions);

  std::span<const double> positions() const { return positions_; }
  std::span<const double> velocities() const { return velocities_; }
  /// A coordinate's current velocity along its axis of the last `update`, as in a constraint row.
  double row_velocity(std::size_t coordinate) const;
  /// Adds a generalised force for the next step.
  void add_force(std::size_t coordinate, double force) const;

  bool linear(std::size_t coordinate) const { return coordinates_[coordinate].linear; }
  const Eigen::Vector3d& axis(std::size_t coordinate) const { return coordinates_[coordinate].axis; }
  dJointID joint_of(std::size_t coordinate) const { return coordinates_[coordinate].joint; }
  dBodyID child(std::size_t coordinate) const { return coordinates_[coordinate].child_id; }
  dBodyID parent(std::size_t coordinate) const { return coordinates_[coordinate].parent_id; }
  /// Whether the axis moves with the child (a universal joint's second) rather than the parent.
  bool axis_on_child(std::size_t coordinate) const { return coordinates_[coordinate].axis_on_child; }

 private:
  /// A joint's geometry, fixed in its bodies.
  struct Geometry {
    JointKind kind;
    std::size_t first;  // coordinate
    Pose parent, child;
    Eigen::Vector3d axis_p{}, u_p{}, w_p{};  // hinge, slider, universal: axis, two directions across it; in the parent
    Eigen::Vector3d axis_c{}, u_c{}, w_c{};  // the same directions in the child
    Eigen::Matrix3d zero_rotation{};         // ball: child to parent at zero
    double offset = 0.0;                     // slider
    Eigen::Vector3d zero_place{};            // free: of the child's centre of mass
  };
  struct CoordinateData {
    bool linear = false;
    bool axis_on_child = false;
    dJointID joint = nullptr;
    dBodyID child_id = nullptr, parent_id = nullptr;
    Pose child, parent;
    Eigen::Vector3d axis;  // world
    Eigen::Vector3d arm;   // slider: from the parent's to the child's centre of mass
  };

  void create_one(dWorldID world, const JointSpec& spec, int joint, const Bodies& bodies);
  void update_hinge(const Geometry& g);
  void update_slider(const Geometry& g);
  void update_universal(const Geometry& g);
  void update_ball(const Geometry& g);
  void update_free(const Geometry& g);

  const simulation::JointTree& tree_;
  std::vector<dJointID> ids_;
  std::vector<Geometry> geometry_;
  std::vector<CoordinateData> coordinates_;
  std::vector<double> positions_, velocities_;
};

}  // namespace lacuna::ode
