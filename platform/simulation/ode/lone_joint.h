#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/bodies.h"
#include "simulation/ode/coordinate_law.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <span>

namespace lacuna::ode {

/// The step of a robot that is one body on a hinge or slider to the world and touches nothing: the equations that
/// dWorldStep solves (constraint rows with the world's ERP and CFM, implicit gyroscopic torque, semi-implicit Euler),
/// to rounding, in a tenth of its time. Seen from the body its constraints are always the same, so they are solved once
/// for all steps; what is left is an equation in one unknown.
class LoneJoint {
 public:
  static bool fits(const RobotSpec& robot);

  /// For a robot whose body stands at its zero pose in ODE's world. `step`: of the integration, s.
  void prepare(const RobotSpec& robot, dWorldID world, dBodyID body, double step);

  /// The law of the joint's stop, where its coordinate is at one or beyond.
  std::optional<CoordinateLaw> stop(double position) const;

  /// Moves the body by one step under the forces that ODE has gathered for it, gravity and `laws`. Returns the
  /// coordinate's velocity, along its axis at the step's start.
  double advance(std::span<const CoordinateLaw> laws);

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Rows = Eigen::Matrix<double, 5, 6>;

  Rows constraints() const;
  Eigen::Matrix<double, 5, 1> drift() const;
  Eigen::Vector3d gyroscopic_torque(const Eigen::Vector3d& angular_velocity) const;
  void move(const Vector6& velocity);

  dWorldID world_ = nullptr;
  dBodyID body_ = nullptr;
  Pose pose_{};
  const double* quaternion_ = nullptr;
  const double *force_ = nullptr, *torque_ = nullptr;  ///< gathered for the step
  bool linear_ = false;
  bool gyroscopic_ = false;  ///< the joint's axis is no principal axis of the body
  double step_ = 0.0, erp_ = 0.0, cfm_ = 0.0;
  double mass_ = 0.0;
  double lower_ = 0.0, upper_ = 0.0;  ///< stops
  // in the world
  Eigen::Vector3d anchor_, axis_;  ///< slider: where the centre of mass was at zero
  Eigen::Quaterniond zero_;
  // in the body, from its centre of mass
  Eigen::Matrix3d inertia_, inverse_inertia_;
  Eigen::Vector3d own_anchor_, own_axis_, across_, aside_;
  // of velocities (linear, angular) in the body: those that the constraints leave, what they add per drift, and what a
  // unit of force on the coordinate adds in a unit of time
  Matrix6 left_;
  Eigen::Matrix<double, 6, 5> corrected_;
  Vector6 along_, pushed_;
  double mobility_ = 0.0;  ///< `pushed_` along the coordinate
};

}  // namespace lacuna::ode
