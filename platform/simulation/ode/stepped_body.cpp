#include "simulation/ode/stepped_body.h"

#include <Eigen/LU>

namespace lacuna::ode {
namespace {

constexpr double kParallel = 1e-24;  ///< square of a sine: a momentum that is turned by less is not turned

/// What ODE keeps at a place, to be changed there.
Eigen::Map<Eigen::Vector3d> written(const double* place) {
  return Eigen::Map<Eigen::Vector3d>(const_cast<double*>(place));
}

}  // namespace

SteppedBody::SteppedBody(dBodyID body, const Pose& pose, const BodySpec& spec)
    : body_(body), pose_(pose), force_(dBodyGetForce(body)), torque_(dBodyGetTorque(body)), mass_(spec.mass) {
  const InertiaSpec& i = spec.inertia;
  inertia_ << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
}

void SteppedBody::move(const Eigen::Vector3d& v, const Eigen::Vector3d& w, double step) const {
  const Eigen::Quaterniond before = pose_.q();
  const Eigen::Quaterniond rate = Eigen::Quaterniond(0.0, w.x(), w.y(), w.z()) * before;
  set_orientation(pose_,
                  Eigen::Quaterniond(Eigen::Vector4d(before.coeffs() + 0.5 * step * rate.coeffs()).normalized()));
  written(pose_.angular_velocity) = w;
  move(v, step);
}

void SteppedBody::move(const Eigen::Vector3d& v, double step) const {
  written(pose_.position) += step * v;
  written(pose_.velocity) = v;
  written(force_).setZero();
  written(torque_).setZero();
  tell_shapes(body_, pose_);
}

Eigen::Vector3d turned_momentum(const Eigen::Vector3d& angular_velocity, const Eigen::Matrix3d& inertia, double step) {
  const Eigen::Vector3d momentum = inertia * angular_velocity;
  const double turning = momentum.cross(angular_velocity).squaredNorm();
  if (turning <= kParallel * momentum.squaredNorm() * angular_velocity.squaredNorm()) return momentum;
  const Eigen::Vector3d a = step * momentum;
  Eigen::Matrix3d turned = inertia;
  turned(0, 1) += a.z(), turned(0, 2) -= a.y(), turned(1, 2) += a.x();
  turned(1, 0) -= a.z(), turned(2, 0) += a.y(), turned(2, 1) -= a.x();
  return inertia * (turned.inverse() * momentum);
}

}  // namespace lacuna::ode
