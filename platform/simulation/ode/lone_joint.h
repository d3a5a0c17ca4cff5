#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/robot_step.h"
#include "simulation/ode/stepped_body.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>

namespace lacuna::ode {

/// The step of a robot that is one body on a hinge or slider to the world and touches nothing. Seen from the body its
/// constraints are always the same, so they are solved once for all steps; what is left is an equation in one unknown.
class LoneJoint : public RobotStep {
 public:
  LoneJoint(const RobotSpec& robot, dWorldID world, const SteppedBody& body, double step);

  std::span<const double> advance(std::span<const CoordinateLaw> laws, std::span<const double> before) override;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Rows = Eigen::Matrix<double, 5, 6>;

  Rows constraints() const;
  Eigen::Matrix<double, 5, 1> drift() const;

  dWorldID world_;
  SteppedBody body_;
  bool linear_;
  bool gyroscopic_;  ///< the joint's axis is no principal axis of the body
  double step_;
  // in the world
  Eigen::Vector3d anchor_, axis_;  ///< slider: where the centre of mass was at zero
  Eigen::Quaterniond zero_;
  // in the body, from its centre of mass
  Eigen::Matrix3d inverse_inertia_;
  Eigen::Vector3d own_anchor_, own_axis_, across_, aside_;
  // of velocities (linear, angular) in the body: those that the constraints leave, what they add per drift, and what a
  // unit of force on the coordinate adds in a unit of time
  Matrix6 left_;
  Eigen::Matrix<double, 6, 5> corrected_;
  Vector6 along_, pushed_;
  double mobility_ = 0.0;  ///< `pushed_` along the coordinate
  double settled_ = 0.0;   ///< velocity of the coordinate after the step
};

}  // namespace lacuna::ode
