#include "simulation/ode/motor_row.h"

#include <algorithm>

namespace lacuna::ode {
namespace {

/// Body in which ODE keeps an axis fixed.
int axis_owner(const Joints& joints, std::size_t coordinate) {
  constexpr int kWorldFrame = 0, kFirstBody = 1, kSecondBody = 2;
  if (joints.axis_on_child(coordinate)) return kFirstBody;
  return joints.parent(coordinate) ? kSecondBody : kWorldFrame;
}

dJointID create_rotational(dWorldID world, const Joints& joints, std::size_t coordinate) {
  const Eigen::Vector3d& axis = joints.axis(coordinate);
  const dJointID joint = dJointCreateAMotor(world, nullptr);
  dJointAttach(joint, joints.child(coordinate), joints.parent(coordinate));
  dJointSetAMotorMode(joint, dAMotorUser);
  dJointSetAMotorNumAxes(joint, 1);
  dJointSetAMotorAxis(joint, 0, axis_owner(joints, coordinate), axis.x(), axis.y(), axis.z());
  return joint;
}

dJointID create_linear(dWorldID world, const Joints& joints, std::size_t coordinate) {
  const Eigen::Vector3d& axis = joints.axis(coordinate);
  const dJointID joint = dJointCreateLMotor(world, nullptr);
  dJointAttach(joint, joints.child(coordinate), joints.parent(coordinate));
  dJointSetLMotorNumAxes(joint, 1);
  dJointSetLMotorAxis(joint, 0, axis_owner(joints, coordinate), axis.x(), axis.y(), axis.z());
  return joint;
}

}  // namespace

void MotorRow::create(dWorldID world, const Joints& joints, std::size_t coordinate) {
  linear_ = joints.linear(coordinate);
  joint_ = linear_ ? create_linear(world, joints, coordinate) : create_rotational(world, joints, coordinate);
  feedback_ = {};
}

void MotorRow::destroy() {
  if (joint_) dJointDestroy(joint_);
  *this = {};
}

void MotorRow::set_law(double compliance, double limit) {
  set(dParamCFM, std::max(compliance, kLeastCompliance));
  set(dParamFMax, limit);
}

double MotorRow::measured_force(const Eigen::Vector3d& axis) const {
  const dReal* f = linear_ ? feedback_.f1 : feedback_.t1;
  return axis.x() * f[0] + axis.y() * f[1] + axis.z() * f[2];
}

void StopRow::create(dWorldID world, const Joints& joints, std::size_t coordinate, double lower, double upper) {
  if (joints.linear(coordinate)) {
    dJointSetSliderParam(joints.joint_of(coordinate), dParamLoStop, lower);
    dJointSetSliderParam(joints.joint_of(coordinate), dParamHiStop, upper);
    return;
  }
  motor_ = create_rotational(world, joints, coordinate);
  dJointSetAMotorParam(motor_, dParamLoStop, lower);
  dJointSetAMotorParam(motor_, dParamHiStop, upper);
}

void StopRow::destroy() {
  if (motor_) dJointDestroy(motor_);
  *this = {};
}

}  // namespace lacuna::ode
