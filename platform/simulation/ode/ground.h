#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/bodies.h"

#include <ode/ode.h>

#include <span>
#include <vector>

namespace lacuna::ode {

/// The ground plane and the bodies' shapes. Each shape is tested against the plane separately: ODE's spaces allocate in
/// a step, and shapes never touch each other.
class Ground {
 public:
  Ground();
  ~Ground();
  Ground(const Ground&) = delete;
  Ground& operator=(const Ground&) = delete;

  void create(dWorldID world, const RobotSpec& robot, const Bodies& bodies, bool measure_force);
  void destroy();

  /// Finds where shapes touch a ground of this slope.
  void collide(double slope);
  double slope() const { return slope_; }

  /// Makes the contacts that `collide` found, for one step; `end_step` removes them and sums up
  /// their forces.
  void begin_step(dWorldID world, const ContactSpec& contact, double step, double rigid_erp);
  void end_step();

  /// Separates the contacts found by `collide` by an invisible distance: where several begin in the same way, as for
  /// parts at equal depth, ODE may find no order to solve them.
  void break_ties();

  std::span<const unsigned char> touching() const { return touching_; }                ///< per body
  std::span<const Eigen::Vector3d> contact_forces() const { return contact_forces_; }  ///< per body, world
  std::span<Eigen::Vector3d> contact_forces() { return contact_forces_; }
  std::size_t most_contacts() const { return contacts_.size(); }

 private:
  struct Shape {
    dGeomID geom;
    int body;
    int most_contacts;
  };
  void add_shape(const ShapeSpec& spec, const BodySpec& body, int index, const Bodies& bodies);
  void align_friction(const Pose& body, dContact& contact) const;

  std::vector<Shape> shapes_;
  dGeomID plane_ = nullptr;
  dJointGroupID group_;
  double slope_ = 0.0;
  bool measure_force_ = false;
  std::vector<dContact> contacts_;  // capacity for all possible contacts
  std::vector<int> contact_bodies_;
  std::vector<dJointFeedback> feedback_;
  std::size_t contact_count_ = 0;
  const Bodies* bodies_ = nullptr;
  std::vector<unsigned char> touching_;
  std::vector<Eigen::Vector3d> contact_forces_;
};

}  // namespace lacuna::ode
