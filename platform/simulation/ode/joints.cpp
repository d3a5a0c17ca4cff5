#include "simulation/ode/joints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna::ode {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d across(const Vector3d& axis) { return axis.unitOrthogonal(); }

/// The angle with the direction of `wrapped` that lies nearest to `before`.
double unwrapped(double wrapped, double before) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (std::abs(before - wrapped) < 0.5 * kTurn) return wrapped;
  return wrapped + kTurn * std::round((before - wrapped) / kTurn);
}

Vector3d rotation_vector(const Matrix3d& rotation) {
  const Eigen::AngleAxisd turn{Eigen::Quaterniond(rotation)};
  return turn.angle() * turn.axis();
}

dJointID make_joint(dWorldID world, const JointSpec& spec, dBodyID child, dBodyID parent) {
  const Vector3d &a = spec.anchor, &x = spec.axis, &y = spec.axis2;
  dJointID joint = nullptr;
  switch (spec.kind) {
    case JointKind::hinge:
      joint = dJointCreateHinge(world, nullptr);
      dJointAttach(joint, child, parent);
      dJointSetHingeAnchor(joint, a.x(), a.y(), a.z());
      dJointSetHingeAxis(joint, x.x(), x.y(), x.z());
      break;
    case JointKind::slider:
      joint = dJointCreateSlider(world, nullptr);
      dJointAttach(joint, child, parent);
      dJointSetSliderAxis(joint, x.x(), x.y(), x.z());
      break;
    case JointKind::universal:  // ODE's first axis is fixed in its first body, here the child
      joint = dJointCreateUniversal(world, nullptr);
      dJointAttach(joint, child, parent);
      dJointSetUniversalAnchor(joint, a.x(), a.y(), a.z());
      dJointSetUniversalAxis1(joint, y.x(), y.y(), y.z());
      dJointSetUniversalAxis2(joint, x.x(), x.y(), x.z());
      break;
    case JointKind::ball:
      joint = dJointCreateBall(world, nullptr);
      dJointAttach(joint, child, parent);
      dJointSetBallAnchor(joint, a.x(), a.y(), a.z());
      break;
    case JointKind::free: break;  // holds nothing
    case JointKind::fixed:
      joint = dJointCreateFixed(world, nullptr);
      dJointAttach(joint, child, parent);
      dJointSetFixed(joint);
      break;
  }
  return joint;
}

}  // namespace

Joints::Joints(const simulation::JointTree& tree)
    : tree_(tree),
      positions_(static_cast<std::size_t>(tree.coordinates), 0.0),
      velocities_(static_cast<std::size_t>(tree.coordinates), 0.0) {}

void Joints::create(dWorldID world, const RobotSpec& robot, const Bodies& bodies) {
  coordinates_.assign(positions_.size(), {});
  for (std::size_t i = 0; i < robot.joints.size(); ++i) create_one(world, robot.joints[i], static_cast<int>(i), bodies);
}

void Joints::create_one(dWorldID world, const JointSpec& spec, int joint, const Bodies& bodies) {
  const auto index = static_cast<std::size_t>(joint);
  const int child = tree_.child[index], parent = tree_.parent[index];
  ids_.push_back(make_joint(world, spec, bodies.id(child), bodies.id(parent)));

  Geometry g{.kind = spec.kind,
             .first = static_cast<std::size_t>(tree_.first_coordinate[index]),
             .parent = bodies.pose(parent),
             .child = bodies.pose(child)};
  const Vector3d axis = spec.axis.normalized();
  const Vector3d u = spec.kind == JointKind::universal ? spec.axis2.normalized() : across(axis);
  const Vector3d w = axis.cross(u);
  const Matrix3d to_parent = g.parent.R().transpose(), to_child = g.child.R().transpose();
  g.axis_p = to_parent * axis, g.u_p = to_parent * u, g.w_p = to_parent * w;
  g.axis_c = to_child * axis, g.u_c = to_child * u, g.w_c = to_child * w;
  g.zero_rotation = to_parent * g.child.R();
  g.offset = axis.dot(g.child.x() - g.parent.x());
  g.zero_place = g.child.x();
  geometry_.push_back(g);

  const int count = simulation::coordinate_count(spec.kind);
  for (int i = 0; i < count; ++i)
    coordinates_[g.first + static_cast<std::size_t>(i)] = {
        .linear = spec.kind == JointKind::slider || (spec.kind == JointKind::free && i < 3),
        .axis_on_child = spec.kind == JointKind::universal && i == 1,
        .joint = ids_.back(),
        .child_id = bodies.id(child),
        .parent_id = bodies.id(parent),
        .child = g.child,
        .parent = g.parent,
        .axis = Vector3d::Zero(),
        .arm = Vector3d::Zero()};
}

void Joints::destroy() {
  for (const dJointID joint : ids_)
    if (joint != nullptr) dJointDestroy(joint);
  ids_.clear();
  geometry_.clear();
  coordinates_.clear();
}

void Joints::set_positions(std::span<const double> positions) {
  std::copy(positions.begin(), positions.end(), positions_.begin());
}

void Joints::update() {
  for (const Geometry& g : geometry_) {
    switch (g.kind) {
      case JointKind::hinge: update_hinge(g); break;
      case JointKind::slider: update_slider(g); break;
      case JointKind::universal: update_universal(g); break;
      case JointKind::ball: update_ball(g); break;
      case JointKind::free: update_free(g); break;
      case JointKind::fixed: break;
    }
  }
}

void Joints::update_hinge(const Geometry& g) {
  const Vector3d turned = g.parent.R().transpose() * (g.child.R() * g.u_c);
  CoordinateData& c = coordinates_[g.first];
  c.axis = g.parent.R() * g.axis_p;
  positions_[g.first] = unwrapped(std::atan2(g.w_p.dot(turned), g.u_p.dot(turned)), positions_[g.first]);
  velocities_[g.first] = c.axis.dot(g.child.w() - g.parent.w());
}

void Joints::update_slider(const Geometry& g) {
  CoordinateData& c = coordinates_[g.first];
  c.axis = g.parent.R() * g.axis_p;
  c.arm = g.child.x() - g.parent.x();
  positions_[g.first] = c.axis.dot(c.arm) - g.offset;
  velocities_[g.first] = row_velocity(g.first);
}

void Joints::update_universal(const Geometry& g) {
  // R(parent ← child) = R(axis, q1)·R(u, q2): the first turns u across the axis, the second turns the axis as seen from
  // the child.
  CoordinateData &first = coordinates_[g.first], &second = coordinates_[g.first + 1];
  first.axis = g.parent.R() * g.axis_p;
  second.axis = g.child.R() * g.u_c;
  const Vector3d u = g.parent.R().transpose() * second.axis;
  const Vector3d axis = g.child.R().transpose() * first.axis;
  positions_[g.first] = unwrapped(std::atan2(g.w_p.dot(u), g.u_p.dot(u)), positions_[g.first]);
  positions_[g.first + 1] = unwrapped(std::atan2(g.w_c.dot(axis), g.axis_c.dot(axis)), positions_[g.first + 1]);
  velocities_[g.first] = row_velocity(g.first);
  velocities_[g.first + 1] = row_velocity(g.first + 1);
}

void Joints::update_ball(const Geometry& g) {
  const Matrix3d relative = g.parent.R().transpose() * g.child.R() * g.zero_rotation.transpose();
  const Vector3d q = rotation_vector(relative);
  for (int i = 0; i < 3; ++i) {
    const std::size_t coordinate = g.first + static_cast<std::size_t>(i);
    coordinates_[coordinate].axis = g.parent.R().col(i);
    positions_[coordinate] = q[i];
    velocities_[coordinate] = row_velocity(coordinate);
  }
}

void Joints::update_free(const Geometry& g) {
  const Vector3d turn = rotation_vector(g.child.R() * g.zero_rotation.transpose());
  const Vector3d place = g.child.x() - g.zero_place;
  for (int i = 0; i < 6; ++i) {
    const std::size_t coordinate = g.first + static_cast<std::size_t>(i);
    coordinates_[coordinate].axis = Vector3d::Unit(i % 3);
    positions_[coordinate] = i < 3 ? place[i] : turn[i - 3];
    velocities_[coordinate] = i < 3 ? g.child.v()[i] : g.child.w()[i - 3];
  }
}

double Joints::row_velocity(std::size_t coordinate) const {
  const CoordinateData& c = coordinates_[coordinate];
  if (!c.linear) return c.axis.dot(c.child.w() - c.parent.w());
  return c.axis.dot(c.child.v() - c.parent.v() - c.parent.w().cross(c.arm));
}

void Joints::add_force(std::size_t coordinate, double force) const {
  const CoordinateData& c = coordinates_[coordinate];
  const Vector3d f = force * c.axis;
  if (!c.linear) {
    dBodyAddTorque(c.child_id, f.x(), f.y(), f.z());
    if (c.parent_id) dBodyAddTorque(c.parent_id, -f.x(), -f.y(), -f.z());
    return;
  }
  dBodyAddForce(c.child_id, f.x(), f.y(), f.z());
  if (!c.parent_id) return;
  const Vector3d reaction = f.cross(c.arm);  // as if the force acted at the child's centre
  dBodyAddForce(c.parent_id, -f.x(), -f.y(), -f.z());
  dBodyAddTorque(c.parent_id, reaction.x(), reaction.y(), reaction.z());
}

}  // namespace lacuna::ode
