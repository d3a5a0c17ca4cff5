#include "simulation/ode/articulated_link.h"

#include <Eigen/LU>

#include <array>

namespace lacuna::ode {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kParallel = 1e-24;  ///< square of a sine: a momentum that is turned by less is not turned
constexpr std::array<double, 4> kUnturned{1, 0, 0, 0};

Quaterniond quaternion_at(const double* q) { return {q[0], q[1], q[2], q[3]}; }

/// The angular velocity after a step without torque, as ODE has it: implicit, so that it never adds energy
/// (C. Lacoursière, "Stabilizing gyroscopic forces in rigid multibody simulations", 2006).
Vector3d turned(const Vector3d& velocity, const Matrix3d& inertia, double step) {
  const Vector3d momentum = inertia * velocity;
  if (momentum.cross(velocity).squaredNorm() <= kParallel * momentum.squaredNorm() * velocity.squaredNorm())
    return velocity;
  const Vector3d a = step * momentum;
  Matrix3d turning = inertia;
  turning(0, 1) += a.z(), turning(0, 2) -= a.y(), turning(1, 2) += a.x();
  turning(1, 0) -= a.z(), turning(2, 0) += a.y(), turning(2, 1) -= a.x();
  return turning.inverse() * momentum;
}

}  // namespace

ArticulatedLink::ArticulatedLink(const BodySpec& spec, const JointSpec& joint, dBodyID child, const Pose& pose,
                                 dBodyID parent, const Pose& parent_pose)
    : body_(child),
      child_(pose),
      parent_(parent_pose),
      quaternion_(dBodyGetQuaternion(child)),
      parent_quaternion_(parent ? dBodyGetQuaternion(parent) : kUnturned.data()),
      force_(dBodyGetForce(child)),
      torque_(dBodyGetTorque(child)),
      linear_(joint.kind == JointKind::slider),
      rooted_(!parent),
      mass_(spec.mass) {
  const InertiaSpec& i = spec.inertia;
  own_inertia_ << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
  const Matrix3d to_child = child_.R().transpose(), to_parent = parent_.R().transpose();
  const Vector3d anchor = linear_ ? Vector3d(child_.x()) : joint.anchor;
  const Vector3d axis = joint.axis.normalized();
  own_anchor_ = to_child * (anchor - child_.x());
  parent_anchor_ = to_parent * (anchor - parent_.x());
  own_axis_ = to_child * axis;
  parent_axis_ = to_parent * axis;
  relative_zero_ = quaternion_at(parent_quaternion_).conjugate() * quaternion_at(quaternion_);
}

void ArticulatedLink::look(const JointSettings& settings) {
  axis_ = parent_.R() * parent_axis_;
  along_ = child_.R() * own_axis_;
  if (linear_)
    look_at_slider(settings.correction);
  else
    look_at_hinge(settings.correction);
  along_ /= along_.dot(axis_);
  gather_momentum(settings);
}

void ArticulatedLink::look_at_hinge(double correction) {
  arm_ = child_.R() * own_anchor_;
  parent_arm_ = parent_.R() * parent_anchor_;
  correction_.linear = correction * (parent_.x() + parent_arm_ - child_.x() - arm_);
  correction_.angular = correction * along_.cross(axis_);
}

/// ODE has the two bodies meet half-way between their centres of mass.
void ArticulatedLink::look_at_slider(double correction) {
  const Vector3d apart = parent_.x() - child_.x();
  const Vector3d off = apart + parent_.R() * parent_anchor_;
  if (rooted_) {
    arm_ = parent_arm_ = Vector3d::Zero();
  } else {
    arm_ = 0.5 * apart;
    parent_arm_ = -arm_;
  }
  correction_.linear = correction * (off - along_.dot(off) * along_);
  const Quaterniond turn = quaternion_at(parent_quaternion_) * relative_zero_ * quaternion_at(quaternion_).conjugate();
  correction_.angular = (turn.w() < 0.0 ? -2.0 : 2.0) * correction * turn.vec();
}

void ArticulatedLink::gather_momentum(const JointSettings& settings) {
  inertia_.noalias() = child_.R() * own_inertia_ * child_.R().transpose();
  own_momentum_.linear = mass_ * child_.v() + settings.step * (Vector3d(MapVector(force_)) + mass_ * settings.gravity);
  own_momentum_.angular = inertia_ * turned(child_.w(), inertia_, settings.step) + settings.step * MapVector(torque_);
}

void ArticulatedLink::move(const Spatial& velocity, double step) const {
  const Vector3d &v = velocity.linear, &w = velocity.angular;
  const Quaterniond before = quaternion_at(quaternion_);
  const Quaterniond rate = Quaterniond(0.0, w.x(), w.y(), w.z()) * before;
  const Quaterniond after(Eigen::Vector4d(before.coeffs() + 0.5 * step * rate.coeffs()).normalized());
  const Vector3d x = child_.x() + step * v;
  set_motion(body_, {x.x(), x.y(), x.z(), after.w(), after.x(), after.y(), after.z(), v.x(), v.y(), v.z(), w.x(), w.y(),
                     w.z()});
  dBodySetForce(body_, 0.0, 0.0, 0.0);
  dBodySetTorque(body_, 0.0, 0.0, 0.0);
}

}  // namespace lacuna::ode
