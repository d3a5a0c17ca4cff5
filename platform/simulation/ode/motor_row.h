#pragma once

#include "simulation/ode/coordinate_law.h"
#include "simulation/ode/joints.h"

#include <ode/ode.h>

namespace lacuna::ode {

/// Least regularisation of a row, (m/s)/N or (rad/s)/(N·m). Two rows on one coordinate without
/// any have no unique solution, and ODE then drops all forces with a message.
inline constexpr double kLeastCompliance = 1e-10;

/// One more constraint row on a joint coordinate, with a joint of ODE's of its own: a force λ
/// within ±limit such that velocity + compliance·λ = target at the end of the step. One row a law:
/// dry friction has target 0, viscous friction a compliance of 1/b, a servo both.
class MotorRow {
 public:
  void create(dWorldID world, const Joints& joints, std::size_t coordinate);
  /// The law alone, unknown to ODE (see RobotStep).
  void create(std::size_t coordinate) {
    law_.coordinate = coordinate;
    exists_ = true;
  }
  void destroy();
  bool exists() const { return exists_; }

  const CoordinateLaw& law() const { return law_; }
  /// Whether the law does anything in the coming step.
  bool acts() const { return law_.upper > 0.0; }
  /// Tells a law that ODE does not know how fast the coordinate became.
  void settle(double velocity);
  void set_target(double velocity) {
    law_.target = velocity;
    set(dParamVel, velocity);
  }
  /// `limit` 0 takes the row out of the step, infinity frees it of the solver's pivoting.
  void set_law(double compliance, double limit);
  /// Force in the last step along `axis` (of that step); needs `measure`.
  double measured_force(const Eigen::Vector3d& axis) const;
  void measure() {
    if (joint_) dJointSetFeedback(joint_, &feedback_);
  }

 private:
  void set(int parameter, double value) {
    if (!joint_) return;
    if (linear_)
      dJointSetLMotorParam(joint_, parameter, value);
    else
      dJointSetAMotorParam(joint_, parameter, value);
  }

  CoordinateLaw law_{.compliance = kLeastCompliance, .lower = 0.0, .upper = 0.0};
  bool exists_ = false;
  dJointID joint_ = nullptr;
  bool linear_ = false;
  dJointFeedback feedback_{};
  double settled_force_ = 0.0;
};

/// Stops of a joint coordinate. A rotation's is a row of its own that is told the angle with its
/// turns, since ODE's hinge angle wraps; a slider has its own.
class StopRow {
 public:
  void create(dWorldID world, const Joints& joints, std::size_t coordinate, double lower, double upper);
  /// The law alone, unknown to ODE (see RobotStep). `correction`: ERP of the world over the step, 1/s.
  void create(dWorldID world, std::size_t coordinate, double lower, double upper, double correction);
  void destroy();
  void set_position(double position) {
    position_ = position;
    if (motor_) dJointSetAMotorAngle(motor_, 0, position);
  }

  /// Whether the coordinate is at a stop or beyond, where ODE does not know of them.
  bool acts() const { return position_ <= lower_ || position_ >= upper_; }
  CoordinateLaw law() const;

 private:
  dJointID motor_ = nullptr;
  // where ODE does not know of them
  std::size_t coordinate_ = 0;
  double lower_ = -dInfinity, upper_ = dInfinity;
  double correction_ = 0.0, compliance_ = 0.0;
  double position_ = 0.0;
};

}  // namespace lacuna::ode
