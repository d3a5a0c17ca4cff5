#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/robot_step.h"
#include "simulation/ode/stepped_body.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>

namespace lacuna::ode {

/// The step of a robot that is one body on a hinge or slider to the world and touches nothing: what its constraints
/// leave of a velocity is one number. ODE's regularisation of the constraints, 1e-10, is left out.
class LoneJoint : public RobotStep {
 public:
  LoneJoint(const RobotSpec& robot, dWorldID world, const SteppedBody& body, double step);

  std::span<const double> advance(std::span<const CoordinateLaw> laws, std::span<const double> before) override;

 private:
  void slide(const Eigen::Vector3d& force, std::span<const CoordinateLaw> laws);
  void turn(const Eigen::Vector3d& force, std::span<const CoordinateLaw> laws);
  double turned_about_axis() const;

  dWorldID world_;
  SteppedBody body_;
  bool linear_;
  bool gyroscopic_;  ///< the hinge's axis is no principal axis of the body
  double step_;
  double correction_;                      ///< of what the body has drifted off its hinge, in a unit of time
  Eigen::Vector3d anchor_, axis_;          ///< in the world
  Eigen::Vector3d own_anchor_, own_axis_;  ///< in the body, from its centre of mass
  double inertia_ = 0.0;                   ///< about the axis, at the centre of mass
  double mobility_ = 0.0;                  ///< of the coordinate
  double settled_ = 0.0;                   ///< velocity of the coordinate after the step
};

}  // namespace lacuna::ode
