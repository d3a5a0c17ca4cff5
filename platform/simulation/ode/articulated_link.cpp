#include "simulation/ode/articulated_link.h"

namespace lacuna::ode {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

ArticulatedLink::ArticulatedLink(const SteppedBody& body, const JointSpec& joint, const Pose& parent, bool rooted)
    : body_(body), parent_(parent), linear_(joint.kind == JointKind::slider), rooted_(rooted) {
  const Pose& child = body_.pose();
  const Matrix3d to_child = child.R().transpose(), to_parent = parent_.R().transpose();
  const Vector3d anchor = linear_ ? Vector3d(child.x()) : joint.anchor;
  const Vector3d axis = joint.axis.normalized();
  own_anchor_ = to_child * (anchor - child.x());
  parent_anchor_ = to_parent * (anchor - parent_.x());
  own_axis_ = to_child * axis;
  parent_axis_ = to_parent * axis;
  relative_zero_ = parent_.q().conjugate() * child.q();
}

void ArticulatedLink::look(const JointSettings& settings) {
  axis_ = parent_.R() * parent_axis_;
  along_ = body_.pose().R() * own_axis_;
  if (linear_)
    look_at_slider(settings.correction);
  else
    look_at_hinge(settings.correction);
  along_ *= 1.0 / along_.dot(axis_);
  gather_momentum(settings);
}

void ArticulatedLink::look_at_hinge(double correction) {
  arm_ = body_.pose().R() * own_anchor_;
  parent_arm_ = parent_.R() * parent_anchor_;
  correction_.linear = correction * (parent_.x() + parent_arm_ - body_.pose().x() - arm_);
  correction_.angular = correction * along_.cross(axis_);
}

/// ODE has the two bodies meet half-way between their centres of mass.
void ArticulatedLink::look_at_slider(double correction) {
  const Vector3d apart = parent_.x() - body_.pose().x();
  const Vector3d off = apart + parent_.R() * parent_anchor_;
  if (rooted_) {
    arm_ = parent_arm_ = Vector3d::Zero();
  } else {
    arm_ = 0.5 * apart;
    parent_arm_ = -arm_;
  }
  correction_.linear = correction * (off - along_.dot(off) * along_);
  const Quaterniond turn = parent_.q() * relative_zero_ * body_.pose().q().conjugate();
  correction_.angular = (turn.w() < 0.0 ? -2.0 : 2.0) * correction * turn.vec();
}

void ArticulatedLink::gather_momentum(const JointSettings& settings) {
  const Pose& pose = body_.pose();
  const double step = settings.step, mass = body_.mass();
  inertia_.noalias() = pose.R() * body_.inertia() * pose.R().transpose();
  own_momentum_.linear = mass * pose.v() + step * (body_.force() + mass * settings.gravity);
  own_momentum_.angular = turned_momentum(pose.w(), inertia_, step) + step * body_.torque();
}

}  // namespace lacuna::ode
