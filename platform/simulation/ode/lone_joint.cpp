#include "simulation/ode/lone_joint.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace lacuna::ode {
namespace {

constexpr double kPrincipal = 1e-12;  ///< of the inertia: less turns no momentum away from the axis

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return matrix;
}

}  // namespace

LoneJoint::LoneJoint(const RobotSpec& robot, dWorldID world, const SteppedBody& body, double step)
    : world_(world), body_(body), linear_(robot.joints.front().kind == JointKind::slider), step_(step) {
  const JointSpec& joint = robot.joints.front();
  const double erp = dWorldGetERP(world), cfm = dWorldGetCFM(world);
  const Pose& pose = body_.pose();
  const MapVector centre = pose.x();
  const MapRotation rotation = pose.R();
  zero_ = pose.q();
  anchor_ = linear_ ? Eigen::Vector3d(centre) : joint.anchor;
  axis_ = joint.axis.normalized();
  inverse_inertia_ = body_.inertia().inverse();
  own_anchor_ = rotation.transpose() * (anchor_ - centre);
  own_axis_ = rotation.transpose() * axis_;
  across_ = own_axis_.unitOrthogonal();
  aside_ = own_axis_.cross(across_);
  const Eigen::Vector3d momentum = body_.inertia() * own_axis_;
  gyroscopic_ = !linear_ && own_axis_.cross(momentum).norm() > kPrincipal * momentum.norm();
  Matrix6 inverse_mass = Matrix6::Zero();
  inverse_mass.topLeftCorner<3, 3>().diagonal().setConstant(1.0 / body_.mass());
  inverse_mass.bottomRightCorner<3, 3>() = inverse_inertia_;
  const Rows rows = constraints();
  const Eigen::Matrix<double, 6, 5> reached = inverse_mass * rows.transpose();
  Eigen::Matrix<double, 5, 5> yielding = rows * reached;
  yielding.diagonal().array() += cfm / step_;
  corrected_ = yielding.llt().solve(reached.transpose()).transpose();
  left_ = Matrix6::Identity() - corrected_ * rows;
  corrected_ *= erp / step_;
  along_.setZero();
  (linear_ ? along_.head<3>() : along_.tail<3>()) = own_axis_;
  pushed_ = left_ * (inverse_mass * along_);
  mobility_ = along_.dot(pushed_);
}

LoneJoint::Rows LoneJoint::constraints() const {
  Rows rows = Rows::Zero();
  if (linear_) {
    rows.topRightCorner<3, 3>().setIdentity();
    rows.row(3).head<3>() = across_;
    rows.row(4).head<3>() = aside_;
  } else {
    rows.topLeftCorner<3, 3>().setIdentity();
    rows.topRightCorner<3, 3>() = -cross_matrix(own_anchor_);
    rows.row(3).tail<3>() = across_;
    rows.row(4).tail<3>() = aside_;
  }
  return rows;
}

/// How far the body has drifted off its joint.
Eigen::Matrix<double, 5, 1> LoneJoint::drift() const {
  Eigen::Matrix<double, 5, 1> errors;
  const Pose& pose = body_.pose();
  const Eigen::Vector3d off = pose.R().transpose() * (anchor_ - pose.x());
  if (linear_) {
    const Eigen::Quaterniond turn = pose.q().conjugate() * zero_;
    errors << (turn.w() < 0.0 ? -2.0 : 2.0) * turn.vec(), across_.dot(off), aside_.dot(off);
  } else {
    const Eigen::Vector3d tilt = own_axis_.cross(pose.R().transpose() * axis_);
    errors << off - own_anchor_, across_.dot(tilt), aside_.dot(tilt);
  }
  return errors;
}

std::span<const double> LoneJoint::advance(std::span<const CoordinateLaw> laws, std::span<const double> /*before*/) {
  dVector3 gravity;
  dWorldGetGravity(world_, gravity);
  const Pose& pose = body_.pose();
  const auto to_body = pose.R().transpose();
  const Eigen::Vector3d force = to_body * (body_.force() + body_.mass() * MapVector(gravity));
  const Eigen::Vector3d turning = to_body * pose.w();
  Eigen::Vector3d gained = step_ * (to_body * body_.torque());
  if (gyroscopic_) gained += turned_momentum(turning, body_.inertia(), step_) - body_.inertia() * turning;
  Vector6 velocity;
  velocity << to_body * pose.v() + step_ / body_.mass() * force, turning + inverse_inertia_ * gained;
  velocity = left_ * velocity + corrected_ * drift();
  const double free = along_.dot(velocity);
  settled_ = settled_velocity(free, step_ * mobility_, laws);
  velocity += (settled_ - free) / mobility_ * pushed_;
  body_.move(pose.R() * velocity.head<3>(), pose.R() * velocity.tail<3>(), step_);
  return {&settled_, 1};
}

}  // namespace lacuna::ode
