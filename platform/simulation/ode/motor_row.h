#pragma once

#include "simulation/ode/joints.h"

#include <ode/ode.h>

namespace lacuna::ode {

/// Smallest regularisation of a row, (m/s)/N or (rad/s)/(N·m). Two rows on one coordinate without any have no unique
/// solution, and ODE then drops all forces with a message.
inline constexpr double kLeastCompliance = 1e-10;

/// One more constraint row on a joint coordinate, with a separate joint of ODE: a force λ within ±limit such that
/// velocity + compliance·λ = target at the end of the step. One row per law: dry friction has target 0, viscous
/// friction a compliance of 1/b, a servo both.
class MotorRow {
 public:
  void create(dWorldID world, const Joints& joints, std::size_t coordinate);
  void destroy();
  bool exists() const { return joint_ != nullptr; }

  void set_target(double velocity) { set(dParamVel, velocity); }
  /// `limit` 0 removes the row from the step, infinity excludes it from the solver's pivoting.
  void set_law(double compliance, double limit);
  /// Force in the last step along `axis` (of that step); needs `measure`.
  double measured_force(const Eigen::Vector3d& axis) const;
  void measure() { dJointSetFeedback(joint_, &feedback_); }

 private:
  void set(int parameter, double value) {
    if (linear_)
      dJointSetLMotorParam(joint_, parameter, value);
    else
      dJointSetAMotorParam(joint_, parameter, value);
  }

  dJointID joint_ = nullptr;
  bool linear_ = false;
  dJointFeedback feedback_{};
};

/// Stops of a joint coordinate. A rotation has a separate row that gets the angle with its turns, because ODE's hinge
/// angle wraps; a slider uses ODE's own stops.
class StopRow {
 public:
  void create(dWorldID world, const Joints& joints, std::size_t coordinate, double lower, double upper);
  void destroy();
  void set_position(double position) {
    if (motor_) dJointSetAMotorAngle(motor_, 0, position);
  }

 private:
  dJointID motor_ = nullptr;
};

}  // namespace lacuna::ode
