#include "simulation/ode/lone_joint.h"

namespace lacuna::ode {
namespace {

constexpr double kPrincipal = 1e-12;  ///< of the inertia: less turns no momentum away from the axis

}  // namespace

LoneJoint::LoneJoint(const RobotSpec& robot, dWorldID world, const SteppedBody& body, double step)
    : world_(world),
      body_(body),
      linear_(robot.joints.front().kind == JointKind::slider),
      step_(step),
      correction_(dWorldGetERP(world) / step),
      anchor_(robot.joints.front().anchor),
      axis_(robot.joints.front().axis.normalized()) {
  const auto to_body = body_.pose().R().transpose();
  own_anchor_ = to_body * (anchor_ - body_.pose().x());
  own_axis_ = to_body * axis_;
  const Eigen::Vector3d momentum = body_.inertia() * own_axis_;
  gyroscopic_ = !linear_ && own_axis_.cross(momentum).norm() > kPrincipal * momentum.norm();
  inertia_ = own_axis_.dot(momentum);
  mobility_ = 1.0 / (linear_ ? body_.mass() : inertia_ + body_.mass() * own_axis_.cross(own_anchor_).squaredNorm());
}

std::span<const double> LoneJoint::advance(std::span<const CoordinateLaw> laws, std::span<const double> /*before*/) {
  dVector3 gravity;
  dWorldGetGravity(world_, gravity);
  const Eigen::Vector3d force = body_.force() + body_.mass() * MapVector(gravity);
  if (linear_)
    slide(force, laws);
  else
    turn(force, laws);
  return {&settled_, 1};
}

void LoneJoint::slide(const Eigen::Vector3d& force, std::span<const CoordinateLaw> laws) {
  const double free = axis_.dot(body_.pose().v()) + step_ * mobility_ * axis_.dot(force);
  settled_ = settled_velocity(free, step_ * mobility_, laws);
  body_.move(settled_ * axis_, step_);
}

/// Of the velocities that the constraints allow, ω·(sideways, axis) of centre and body, the one that is next to the
/// free velocity in the measure of the mass; and, at right angles to them all in that measure, what takes the body back
/// where it has drifted to.
void LoneJoint::turn(const Eigen::Vector3d& force, std::span<const CoordinateLaw> laws) {
  const Pose& pose = body_.pose();
  const Eigen::Vector3d to_anchor = pose.R() * own_anchor_;
  const Eigen::Vector3d sideways = to_anchor.cross(axis_);
  const Eigen::Vector3d back = correction_ * (anchor_ - pose.x() - to_anchor);
  double momentum = inertia_ * axis_.dot(pose.w()) + step_ * axis_.dot(body_.torque());
  if (gyroscopic_) momentum += turned_about_axis();
  momentum += sideways.dot(body_.mass() * (pose.v() - back) + step_ * force);
  settled_ = settled_velocity(mobility_ * momentum, step_ * mobility_, laws);
  body_.move(back + settled_ * sideways, settled_ * axis_, step_);
}

/// What a step without torque adds to the angular momentum about the axis.
double LoneJoint::turned_about_axis() const {
  const Eigen::Vector3d turning = body_.pose().R().transpose() * body_.pose().w();
  return own_axis_.dot(turned_momentum(turning, body_.inertia(), step_) - body_.inertia() * turning);
}

}  // namespace lacuna::ode
