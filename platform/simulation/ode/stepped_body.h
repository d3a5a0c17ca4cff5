#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/bodies.h"

#include <Eigen/Core>

namespace lacuna::ode {

/// A body of ODE's world as ODE's own step treats it, for those who do that step in its place: what it has gathered,
/// and how it moves.
class SteppedBody {
 public:
  SteppedBody(dBodyID body, const Pose& pose, const BodySpec& spec);

  const Pose& pose() const { return pose_; }
  double mass() const { return mass_; }
  const Eigen::Matrix3d& inertia() const { return inertia_; }  ///< in the body, about its centre of mass
  // gathered for the step, in the world
  MapVector force() const { return MapVector(force_); }
  MapVector torque() const { return MapVector(torque_); }

  /// Moves the body for a step at this velocity, in the world; what was gathered has been used.
  void move(const Eigen::Vector3d& velocity, const Eigen::Vector3d& angular_velocity, double step) const;
  /// The same of a body that does not turn.
  void move(const Eigen::Vector3d& velocity, double step) const;

 private:
  dBodyID body_;
  Pose pose_;
  const double *force_, *torque_;
  double mass_;
  Eigen::Matrix3d inertia_;
};

/// The angular momentum after a step without torque, as ODE has it: implicit, so that it never adds energy
/// (C. Lacoursière, "Stabilizing gyroscopic forces in rigid multibody simulations", 2006). Everything in the same axes.
Eigen::Vector3d turned_momentum(const Eigen::Vector3d& angular_velocity, const Eigen::Matrix3d& inertia, double step);

}  // namespace lacuna::ode
