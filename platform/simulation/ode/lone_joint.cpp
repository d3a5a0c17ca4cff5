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
  const dReal* q = dBodyGetQuaternion(body);
  zero_ = Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  const MapVector centre(dBodyGetPosition(body));
  const MapRotation rotation(dBodyGetRotation(body));
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
  along_.setZero();
  (linear_ ? along_.head<3>() : along_.tail<3>()) = own_axis_;
  pushed_ = left_ * (inverse_mass * along_);
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

/// Velocities that bring a body back which has drifted off its joint.
Eigen::Matrix<double, 5, 1> LoneJoint::corrections(const Pose& pose) const {
  Eigen::Matrix<double, 5, 1> errors;
  const Eigen::Vector3d off = pose.R().transpose() * (anchor_ - pose.x());
  if (linear_) {
    const dReal* q = dBodyGetQuaternion(body_);
    const Eigen::Quaterniond turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).conjugate() * zero_;
    errors << (turn.w() < 0.0 ? -2.0 : 2.0) * turn.vec(), across_.dot(off), aside_.dot(off);
  } else {
    const Eigen::Vector3d tilt = own_axis_.cross(pose.R().transpose() * axis_);
    errors << off - own_anchor_, across_.dot(tilt), aside_.dot(tilt);
  }
  return erp_ / step_ * errors;
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
  const Pose pose{dBodyGetPosition(body_), dBodyGetRotation(body_), dBodyGetLinearVel(body_),
                  dBodyGetAngularVel(body_)};
  const auto to_body = pose.R().transpose();
  Vector6 velocity;
  velocity << to_body * pose.v(), to_body * pose.w();
  const Eigen::Vector3d force = to_body * (MapVector(dBodyGetForce(body_)) + mass_ * MapVector(gravity));
  Eigen::Vector3d torque = to_body * MapVector(dBodyGetTorque(body_));
  if (gyroscopic_) torque += gyroscopic_torque(velocity.tail<3>());
  velocity.head<3>() += step_ / mass_ * force;
  velocity.tail<3>() += step_ * (inverse_inertia_ * torque);
  velocity = left_ * velocity + corrected_ * corrections(pose);
  const double free = along_.dot(velocity), mobility = step_ * along_.dot(pushed_);
  const double settled = settled_velocity(free, mobility, laws);
  velocity += (settled - free) / along_.dot(pushed_) * pushed_;
  move(velocity, pose);
  return settled;
}

void LoneJoint::move(const Vector6& velocity, const Pose& pose) {
  const Eigen::Vector3d v = pose.R() * velocity.head<3>(), w = pose.R() * velocity.tail<3>();
  const dReal* q = dBodyGetQuaternion(body_);
  const Eigen::Quaterniond before(q[0], q[1], q[2], q[3]);
  const Eigen::Quaterniond rate = Eigen::Quaterniond(0.0, w.x(), w.y(), w.z()) * before;
  const Eigen::Quaterniond after(Eigen::Vector4d(before.coeffs() + 0.5 * step_ * rate.coeffs()).normalized());
  const Eigen::Vector3d x = pose.x() + step_ * v;
  set_motion(body_, {x.x(), x.y(), x.z(), after.w(), after.x(), after.y(), after.z(), v.x(), v.y(), v.z(), w.x(), w.y(),
                     w.z()});
  dBodySetForce(body_, 0.0, 0.0, 0.0);
  dBodySetTorque(body_, 0.0, 0.0, 0.0);
}

}  // namespace lacuna::ode
