#include "simulation/ode/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna::ode {
namespace {

constexpr double kFarthest = 1e6;  // m
constexpr double kFastest = 1e6;   // m/s and rad/s

constexpr std::array<double, 4> kZero{};
constexpr std::array<double, 12> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

void set_mass(dBodyID body, const BodySpec& spec) {
  dMass mass;
  const InertiaSpec& inertia = spec.inertia;
  dMassSetParameters(&mass, spec.mass, 0, 0, 0, inertia.xx, inertia.yy, inertia.zz, inertia.xy, inertia.xz, inertia.yz);
  dBodySetMass(body, &mass);
}

void set_pose(dBodyID body, const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation) {
  const dQuaternion q = {orientation.w(), orientation.x(), orientation.y(), orientation.z()};
  dBodySetPosition(body, position.x(), position.y(), position.z());
  dBodySetQuaternion(body, q);
}

double largest(const double* vector) {
  // A sum, unlike a maximum, keeps a NaN.
  return std::abs(vector[0]) + std::abs(vector[1]) + std::abs(vector[2]);
}

}  // namespace

void set_motion(dBodyID body, const Pose& pose, const BodyState& s) {
  std::copy_n(s.begin(), 3, const_cast<double*>(pose.position));
  set_orientation(pose, {s[3], s[4], s[5], s[6]});
  std::copy_n(s.begin() + 7, 3, const_cast<double*>(pose.velocity));
  std::copy_n(s.begin() + 10, 3, const_cast<double*>(pose.angular_velocity));
  tell_shapes(body, pose);
}

void set_orientation(const Pose& pose, const Eigen::Quaterniond& q) {
  // dBodySetQuaternion normalises, which changes the last bits of a normalised quaternion. So everything is written
  // where ODE keeps it, with the rotation of dQtoR, bit for bit.
  auto* quaternion = const_cast<double*>(pose.quaternion);
  quaternion[0] = q.w(), quaternion[1] = q.x(), quaternion[2] = q.y(), quaternion[3] = q.z();
  auto* rotation = const_cast<double*>(pose.rotation);
  const double xx = 2.0 * q.x() * q.x(), yy = 2.0 * q.y() * q.y(), zz = 2.0 * q.z() * q.z();
  rotation[0] = 1.0 - yy - zz;
  rotation[1] = 2.0 * (q.x() * q.y() - q.w() * q.z());
  rotation[2] = 2.0 * (q.x() * q.z() + q.w() * q.y());
  rotation[4] = 2.0 * (q.x() * q.y() + q.w() * q.z());
  rotation[5] = 1.0 - xx - zz;
  rotation[6] = 2.0 * (q.y() * q.z() - q.w() * q.x());
  rotation[8] = 2.0 * (q.x() * q.z() - q.w() * q.y());
  rotation[9] = 2.0 * (q.y() * q.z() + q.w() * q.x());
  rotation[10] = 1.0 - xx - yy;
}

void tell_shapes(dBodyID body, const Pose& pose) {
  if (dBodyGetFirstGeom(body) == nullptr) return;
  dBodySetPosition(body, pose.position[0], pose.position[1], pose.position[2]);
}

void Bodies::create(dWorldID world, const RobotSpec& robot) {
  for (const BodySpec& spec : robot.bodies) {
    const dBodyID body = dBodyCreate(world);
    ids_.push_back(body);
    poses_.push_back({dBodyGetPosition(body), dBodyGetRotation(body), dBodyGetLinearVel(body), dBodyGetAngularVel(body),
                      dBodyGetQuaternion(body)});
    set_mass(body, spec);
    masses_.push_back(spec.mass);
    held_.push_back({});
    const Eigen::Quaterniond orientation = spec.orientation.normalized();
    set_pose(body, spec.position + orientation * spec.com, orientation);
  }
}

void Bodies::destroy() {
  for (const dBodyID body : ids_) dBodyDestroy(body);
  ids_.clear();
  poses_.clear();
  masses_.clear();
  held_.clear();
}

Eigen::Vector3d Bodies::centre_of_mass() const {
  Eigen::Vector3d sum(0.0, 0.0, 0.0);
  double mass = 0.0;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    sum += masses_[i] * poses_[i].x();
    mass += masses_[i];
  }
  return mass > 0.0 ? Eigen::Vector3d(sum / mass) : sum;
}

void Bodies::place(std::span<const simulation::BodyMotion> motions) {
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const simulation::BodyMotion& motion = motions[i];
    set_pose(ids_[i], motion.position, motion.orientation);
    dBodySetLinearVel(ids_[i], motion.velocity.x(), motion.velocity.y(), motion.velocity.z());
    dBodySetAngularVel(ids_[i], motion.angular_velocity.x(), motion.angular_velocity.y(), motion.angular_velocity.z());
  }
}

void Bodies::save(simulation::StateWriter& writer) const {
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    writer.put(std::span(poses_[i].position, 3));
    writer.put(std::span(poses_[i].quaternion, 4));
    writer.put(std::span(poses_[i].velocity, 3));
    writer.put(std::span(poses_[i].angular_velocity, 3));
  }
}

void Bodies::load(simulation::StateReader& reader) {
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    BodyState state{};
    reader.get(state);
    set_motion(ids_[i], poses_[i], state);
  }
}

void Bodies::hold() {
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const Pose& pose = poses_[i];
    double* motion = held_[i].motion.data();
    motion = std::copy_n(pose.position, 3, motion);
    motion = std::copy_n(pose.quaternion, 4, motion);
    motion = std::copy_n(pose.velocity, 3, motion);
    std::copy_n(pose.angular_velocity, 3, motion);
    std::copy_n(dBodyGetForce(ids_[i]), 3, held_[i].force.begin());
    std::copy_n(dBodyGetTorque(ids_[i]), 3, held_[i].torque.begin());
  }
}

void Bodies::take_back() {
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const auto& [motion, force, torque] = held_[i];
    set_motion(ids_[i], poses_[i], motion);
    dBodySetForce(ids_[i], force[0], force[1], force[2]);
    dBodySetTorque(ids_[i], torque[0], torque[1], torque[2]);
  }
}

void Bodies::read(std::span<Eigen::Vector3d> positions, std::span<Eigen::Vector3d> velocities,
                  std::span<Eigen::Quaterniond> orientations, std::span<Eigen::Vector3d> angular_velocities) const {
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    positions[i] = poses_[i].x();
    velocities[i] = poses_[i].v();
    orientations[i] = poses_[i].q();
    angular_velocities[i] = poses_[i].w();
  }
}

int Bodies::exploded() const {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const Pose& pose = poses_[i];
    const bool sane = largest(pose.position) < kFarthest && largest(pose.velocity) < kFastest &&
                      largest(pose.angular_velocity) < kFastest;
    if (!sane) return static_cast<int>(i);
  }
  return -1;
}

std::string Bodies::describe(int body) const {
  const Pose& pose = poses_[static_cast<std::size_t>(body)];
  if (!(largest(pose.position) < kFarthest))
    return "is more than " + std::to_string(static_cast<int>(kFarthest)) + " m away";
  if (!(largest(pose.velocity) < kFastest))
    return "moves faster than " + std::to_string(static_cast<int>(kFastest)) + " m/s";
  return "turns faster than " + std::to_string(static_cast<int>(kFastest)) + " rad/s";
}

Pose Bodies::pose(int body) const {
  if (body >= 0) return poses_[static_cast<std::size_t>(body)];
  return {kZero.data(), kIdentity.data(), kZero.data(), kZero.data(), kIdentity.data()};
}

}  // namespace lacuna::ode
