#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/stepped_body.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace lacuna::ode {

/// A velocity, a momentum or an impulse in the world's axes. Of a body at its centre of mass, of a joint at its point.
struct Spatial {
  Eigen::Vector3d linear, angular;

  static Spatial zero() { return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}; }
  Spatial& operator+=(const Spatial& other) {
    linear += other.linear;
    angular += other.angular;
    return *this;
  }
  friend Spatial operator+(const Spatial& a, const Spatial& b) { return {a.linear + b.linear, a.angular + b.angular}; }
  friend Spatial operator-(const Spatial& a, const Spatial& b) { return {a.linear - b.linear, a.angular - b.angular}; }
  friend Spatial operator*(double factor, const Spatial& a) { return {factor * a.linear, factor * a.angular}; }
  double dot(const Spatial& other) const { return linear.dot(other.linear) + angular.dot(other.angular); }
};

/// a × b, two numbers at a time as they lie in memory: to read others together would wait for what was just written.
inline Eigen::Vector3d cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector2d turned = b.z() * Eigen::Vector2d(a.y(), a.x()) - a.z() * Eigen::Vector2d(b.y(), b.x());
  return {turned.x(), -turned.y(), a.x() * b.y() - a.y() * b.x()};
}

/// What the world asks of its joints.
struct JointSettings {
  double step = 0.0;        ///< s
  double correction = 0.0;  ///< share of a drift that is corrected in a step, over the step: ERP/h, 1/s
  double compliance = 0.0;  ///< velocity by which a joint yields per impulse: CFM/h
  Eigen::Vector3d gravity{0.0, 0.0, 0.0};
};

/// A body of a tree of joints with the hinge or slider that holds it to its parent. `look` gives what follows from
/// where the bodies are: the joint's geometry, the constraints that ODE's joints of these kinds ask for, and the
/// momentum that the body would have by itself after the step.
class ArticulatedLink {
 public:
  /// For bodies that stand at their zero poses. `rooted`: the parent is the world.
  ArticulatedLink(const SteppedBody& body, const JointSpec& joint, const Pose& parent, bool rooted);

  void look(const JointSettings& settings);

  /// Velocity of the body where its parent has this one and the joint `relative`.
  Spatial carried(const Spatial& parent, const Spatial& relative) const {
    const Eigen::Vector3d angular = parent.angular + relative.angular;
    return {parent.linear + cross(parent.angular, parent_arm_) - cross(angular, arm_) + relative.linear, angular};
  }
  /// The same where the joint holds still.
  Spatial carried(const Spatial& parent) const {
    return {parent.linear + cross(parent.angular, parent_arm_ - arm_), parent.angular};
  }
  /// Velocity of the body where only its joint moves, at a coordinate's velocity of 1.
  Spatial along() const {
    if (linear_) return {along_, Eigen::Vector3d::Zero()};
    return {cross(arm_, along_), along_};
  }
  Spatial momentum(const Spatial& velocity) const {
    return {body_.mass() * velocity.linear, inertia_ * velocity.angular};
  }
  /// What the joint must pass on for the body, and those that it holds, to gain this momentum.
  Spatial passed_on(const Spatial& gained) const {
    return {gained.linear, gained.angular - cross(arm_, gained.linear)};
  }
  /// The same as seen from the parent's centre of mass.
  Spatial reaction(const Spatial& passed) const {
    return {passed.linear, passed.angular + cross(parent_arm_, passed.linear)};
  }

  /// What acts on the coordinate, of what the joint passes on; the rest is the constraints'.
  double share(const Spatial& passed) const { return along_.dot(linear_ ? passed.linear : passed.angular); }
  Spatial rest(const Spatial& passed) const { return along_axis(-share(passed), axis_, passed); }
  double coordinate_velocity(const Spatial& relative) const {
    return axis_.dot(linear_ ? relative.linear : relative.angular);
  }
  /// `relative` with the coordinate's velocity made this one.
  Spatial at_coordinate_velocity(double velocity, const Spatial& relative) const {
    return along_axis(velocity - coordinate_velocity(relative), along_, relative);
  }

  const Spatial& correction() const { return correction_; }  ///< relative velocity that corrects the joint's drift
  const Spatial& own_momentum() const { return own_momentum_; }

  void move(const Spatial& velocity, double step) const { body_.move(velocity.linear, velocity.angular, step); }

 private:
  /// `start` and more of what is the coordinate's.
  Spatial along_axis(double more, const Eigen::Vector3d& axis, const Spatial& start) const {
    if (linear_) return {start.linear + more * axis, start.angular};
    return {start.linear, start.angular + more * axis};
  }
  void look_at_hinge(double correction);
  void look_at_slider(double correction);
  void gather_momentum(const JointSettings& settings);

  SteppedBody body_;
  Pose parent_;
  bool linear_, rooted_;
  // fixed in the body, or in the parent
  Eigen::Vector3d own_anchor_, own_axis_, parent_anchor_, parent_axis_;  ///< slider: the parent's anchor is the zero
  Eigen::Quaterniond relative_zero_;                                     ///< of the body in its parent
  // of this step, in the world
  Eigen::Matrix3d inertia_{};
  Eigen::Vector3d arm_{}, parent_arm_{};  ///< from the centres of mass to the joint's point
  Eigen::Vector3d axis_{};                ///< as the parent has it: that of the laws on the coordinate
  Eigen::Vector3d along_{};               ///< as the body has it, that of the constraints; `axis_` along it is 1
  Spatial correction_{}, own_momentum_{};
};

}  // namespace lacuna::ode
