#pragma once

#include "simulation/articulated/spatial.h"
#include "simulation/articulated/tree.h"

#include <span>
#include <vector>

namespace lacuna::articulated {

/// Displacement of a body from its zero pose: its point p is at turn·p + shift.
struct Displacement {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift{0.0, 0.0, 0.0};
  Eigen::Vector3d moved(const Eigen::Vector3d& point) const { return turn * point + shift; }
};

/// Force on a body's centre of mass and torque, world axes.
struct BodyForce {
  Eigen::Vector3d force{0.0, 0.0, 0.0}, torque{0.0, 0.0, 0.0};
};

/// The equations of motion of a tree at one configuration, M(q)·dv/dt + bias(q, v) = forces, with the velocities as the
/// tree counts them: the inertia M by composite bodies, the bias by the recursive Newton–Euler algorithm (Featherstone
/// 2008, chapters 5 and 6). Allocates nothing after construction.
class Dynamics {
 public:
  explicit Dynamics(const Tree& tree);

  /// Updates the numbers of the tree.
  void take_numbers();
  /// A robot of one hinge or slider to the world takes less work if its body is not needed.
  void place(std::span<const double> configuration, bool with_bodies);

  /// For the current configuration; by link.
  const Displacement& displacement(std::size_t link) const { return displacements_[link]; }
  const Eigen::Vector3d& centre(std::size_t link) const { return centres_[link]; }
  /// Of each link, for these velocities.
  void move(std::span<const double> velocities);
  Eigen::Vector3d centre_velocity(std::size_t link) const;
  const Eigen::Vector3d& angular_velocity(std::size_t link) const { return velocities_[link].angular; }

  /// dofs × dofs, row after row; both triangles.
  void inertia(std::span<double> out);
  /// Generalised forces for zero acceleration at these velocities (of the last `move`): inertial forces, less gravity
  /// and less `forces` on the bodies, one per link.
  void bias(const Eigen::Vector3d& gravity, std::span<const BodyForce> forces, std::span<double> out);
  /// Adds the resistance of a force −damping·velocity at each body's centre of mass (and a torque −angular·velocity).
  void add_drag(std::size_t link, double damping, double angular, std::span<double> inertia_like) const;

 private:
  bool is_lone() const;
  double lone_weight(const Eigen::Vector3d& gravity) const;
  void place_link(std::size_t index, const double* q);
  void set_axis(int dof, const Eigen::Vector3d& axis, const Eigen::Vector3d& from_reference);
  Eigen::Vector3d from_reference(std::size_t link, const Eigen::Vector3d& point) const {
    return point - references_[static_cast<std::size_t>(tree_.links()[link].root)];
  }
  /// Twist with which the axis of the link's dof `i` moves.
  Twist carrier(const Link& link, int i, std::span<const double> velocities) const;

  const Tree& tree_;
  const bool lone_;
  bool only_coordinate_ = false;  ///< for the only joint
  double coordinate_ = 0.0, lone_inertia_ = 0.0;
  Eigen::Vector3d at_zero_{0.0, 0.0, 0.0},
      at_quarter_{0.0, 0.0, 0.0};            ///< the mass's moment across the axis, and the same rotated by 90°
  std::vector<Displacement> displacements_;  // per link
  std::vector<Eigen::Vector3d> centres_, references_;
  std::vector<SpatialInertia> inertias_, composites_;
  std::vector<Twist> axes_;                        // per dof
  std::vector<Twist> velocities_, accelerations_;  // per link; accelerations at rest of the dofs
  std::vector<Wrench> forces_;
};

}  // namespace lacuna::articulated
