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

Eigen::Quaterniond quaternion_at(const double* q) { return {q[0], q[1], q[2], q[3]}; }

}  // namespace

bool LoneJoint::fits(const RobotSpec& robot) {
  if (robot.bodies.size() != 1 || robot.joints.size() != 1) return false;
  if (robot.contact.ground && !robot.bodies.front().shapes.empty()) return false;
  return robot.joints.front().kind == JointKind::hinge || robot.joints.front().kind == JointKind::slider;
}

void LoneJoint::prepare(const RobotSpec& robot, dWorldID world, dBodyID body, double step) {
  const BodySpec& spec = robot.bodies.front();
  const JointSpec& joint = robot.joints.front();
  world_ = world;
  body_ = body;
  linear_ = joint.kind == JointKind::slider;
  step_ = step;
  erp_ = dWorldGetERP(world);
  cfm_ = dWorldGetCFM(world);
  mass_ = spec.mass;
  lower_ = joint.lower;
  upper_ = joint.upper;
  pose_ = {dBodyGetPosition(body), dBodyGetRotation(body), dBodyGetLinearVel(body), dBodyGetAngularVel(body)};
  quaternion_ = dBodyGetQuaternion(body);
  force_ = dBodyGetForce(body);
  torque_ = dBodyGetTorque(body);
  zero_ = quaternion_at(quaternion_);
  const MapVector centre = pose_.x();
  const MapRotation rotation = pose_.R();
  anchor_ = linear_ ? Eigen::Vector3d(centre) : joint.anchor;
  axis_ = joint.axis.normalized();
  const InertiaSpec& i = spec.inertia;
  inertia_ << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
  inverse_inertia_ = inertia_.inverse();
  own_anchor_ = rotation.transpose() * (anchor_ - centre);
  own_axis_ = rotation.transpose() * axis_;
  across_ = own_axis_.unitOrthogonal();
  aside_ = own_axis_.cross(across_);
  const Eigen::Vector3d momentum = inertia_ * own_axis_;
  gyroscopic_ = !linear_ && own_axis_.cross(momentum).norm() > kPrincipal * momentum.norm();

  Matrix6 inverse_mass = Matrix6::Zero();
  inverse_mass.topLeftCorner<3, 3>().diagonal().setConstant(1.0 / mass_);
  inverse_mass.bottomRightCorner<3, 3>() = inverse_inertia_;
  const Rows rows = constraints();
  const Eigen::Matrix<double, 6, 5> reached = inverse_mass * rows.transpose();
  Eigen::Matrix<double, 5, 5> yielding = rows * reached;
  yielding.diagonal().array() += cfm_ / step_;
  corrected_ = yielding.llt().solve(reached.transpose()).transpose();
  left_ = Matrix6::Identity() - corrected_ * rows;
  corrected_ *= erp_ / step_;
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
  const Eigen::Vector3d off = pose_.R().transpose() * (anchor_ - pose_.x());
  if (linear_) {
    const Eigen::Quaterniond turn = quaternion_at(quaternion_).conjugate() * zero_;
    errors << (turn.w() < 0.0 ? -2.0 : 2.0) * turn.vec(), across_.dot(off), aside_.dot(off);
  } else {
    const Eigen::Vector3d tilt = own_axis_.cross(pose_.R().transpose() * axis_);
    errors << off - own_anchor_, across_.dot(tilt), aside_.dot(tilt);
  }
  return errors;
}

/// As ODE has it: implicit, so that it never adds energy (C. Lacoursière, "Stabilizing gyroscopic forces in rigid
/// multibody simulations", 2006).
Eigen::Vector3d LoneJoint::gyroscopic_torque(const Eigen::Vector3d& angular_velocity) const {
  const Eigen::Vector3d momentum = inertia_ * angular_velocity;
  const Eigen::Matrix3d turning = inertia_ - step_ * cross_matrix(momentum);
  return (inertia_ * (turning.inverse() * momentum) - momentum) / step_;
}

std::optional<CoordinateLaw> LoneJoint::stop(double position) const {
  const bool below = position <= lower_;
  if (!below && position < upper_) return std::nullopt;
  CoordinateLaw law{.target = erp_ / step_ * ((below ? lower_ : upper_) - position), .compliance = cfm_};
  if (lower_ != upper_) (below ? law.lower : law.upper) = 0.0;
  return law;
}

double LoneJoint::advance(std::span<const CoordinateLaw> laws) {
  dVector3 gravity;
  dWorldGetGravity(world_, gravity);
  const auto to_body = pose_.R().transpose();
  Vector6 velocity;
  velocity << to_body * pose_.v(), to_body * pose_.w();
  const Eigen::Vector3d force = to_body * (MapVector(force_) + mass_ * MapVector(gravity));
  Eigen::Vector3d torque = to_body * MapVector(torque_);
  if (gyroscopic_) torque += gyroscopic_torque(velocity.tail<3>());
  velocity.head<3>() += step_ / mass_ * force;
  velocity.tail<3>() += step_ * (inverse_inertia_ * torque);
  velocity = left_ * velocity + corrected_ * drift();
  const double free = along_.dot(velocity);
  const double settled = settled_velocity(free, step_ * mobility_, laws);
  velocity += (settled - free) / mobility_ * pushed_;
  move(velocity);
  return settled;
}

void LoneJoint::move(const Vector6& velocity) {
  const Eigen::Vector3d v = pose_.R() * velocity.head<3>(), w = pose_.R() * velocity.tail<3>();
  const Eigen::Quaterniond before = quaternion_at(quaternion_);
  const Eigen::Quaterniond rate = Eigen::Quaterniond(0.0, w.x(), w.y(), w.z()) * before;
  const Eigen::Quaterniond after(Eigen::Vector4d(before.coeffs() + 0.5 * step_ * rate.coeffs()).normalized());
  const Eigen::Vector3d x = pose_.x() + step_ * v;
  set_motion(body_, {x.x(), x.y(), x.z(), after.w(), after.x(), after.y(), after.z(), v.x(), v.y(), v.z(), w.x(), w.y(),
                     w.z()});
  dBodySetForce(body_, 0.0, 0.0, 0.0);
  dBodySetTorque(body_, 0.0, 0.0, 0.0);
}

}  // namespace lacuna::ode
