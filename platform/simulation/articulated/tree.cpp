#include "simulation/articulated/tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

LinkKind kind_of(JointKind kind) {
  switch (kind) {
    case JointKind::hinge: return LinkKind::hinge;
    case JointKind::slider: return LinkKind::slider;
    case JointKind::universal: return LinkKind::universal;
    case JointKind::ball: return LinkKind::ball;
    case JointKind::free: return LinkKind::floating;
    case JointKind::fixed: break;
  }
  return LinkKind::fixed;
}

int dofs_of(LinkKind kind) {
  switch (kind) {
    case LinkKind::hinge:
    case LinkKind::slider: return 1;
    case LinkKind::universal: return 2;
    case LinkKind::ball: return 3;
    case LinkKind::floating: return 6;
    case LinkKind::fixed: break;
  }
  return 0;
}

int positions_of(LinkKind kind) {
  if (kind == LinkKind::ball) return 4;
  return kind == LinkKind::floating ? 7 : dofs_of(kind);
}

Quaterniond quaternion_at(const double* at) { return {at[0], at[1], at[2], at[3]}; }

void put(const Quaterniond& turn, double* at) {
  at[0] = turn.w();
  at[1] = turn.x();
  at[2] = turn.y();
  at[3] = turn.z();
}

Quaterniond turn_by(const Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  // sin(x/2)/x, to rounding where x is small.
  const double share = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  Quaterniond turn;
  turn.w() = std::cos(0.5 * angle);
  turn.vec() = share * rotation_vector;
  return turn;
}

Vector3d rotation_vector(const Quaterniond& turn) {
  const double sine = turn.vec().norm();
  if (sine == 0.0) return Vector3d::Zero();
  const double side = turn.w() < 0.0 ? -1.0 : 1.0;
  return 2.0 * std::atan2(sine, side * turn.w()) * side / sine * turn.vec();
}

void turn_at(double* at, const Vector3d& by) { put((turn_by(by) * quaternion_at(at)).normalized(), at); }

}  // namespace

Tree::Tree(const RobotSpec& robot, const simulation::JointTree& joints) : link_of_body_(robot.bodies.size()) {
  std::vector<bool> held(robot.bodies.size(), false);
  for (const int child : joints.child) held[static_cast<std::size_t>(child)] = true;
  const auto add = [&](LinkKind kind, int body, int parent, int joint) {
    const int index = static_cast<int>(links_.size());
    Link& link = links_.emplace_back();
    link.kind = kind;
    link.body = body;
    link.parent = parent;
    link.root = parent < 0 ? index : links_[static_cast<std::size_t>(parent)].root;
    link.dof = static_cast<int>(dofs_);
    link.dofs = dofs_of(kind);
    link.position = static_cast<int>(positions_);
    dofs_ += static_cast<std::size_t>(link.dofs);
    positions_ += static_cast<std::size_t>(positions_of(kind));
    joint_of_link_.push_back(joint);
    link_of_body_[static_cast<std::size_t>(body)] = static_cast<std::size_t>(index);
  };
  for (std::size_t body = 0; body < held.size(); ++body)
    if (!held[body]) add(LinkKind::floating, static_cast<int>(body), -1, -1);
  dof_of_coordinate_.resize(static_cast<std::size_t>(joints.coordinates));
  for (const int index : joints.outward) {
    const auto joint = static_cast<std::size_t>(index);
    const int parent = joints.parent[joint];
    add(kind_of(robot.joints[joint].kind), joints.child[joint],
        parent < 0 ? -1 : static_cast<int>(link_of_body_[static_cast<std::size_t>(parent)]), index);
    for (int i = 0; i < links_.back().dofs; ++i)
      dof_of_coordinate_[nth(joints.first_coordinate[joint], i)] = nth(links_.back().dof, i);
  }
  set(robot);
}

void Tree::set(const RobotSpec& robot) {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Link& link = links_[i];
    const BodySpec& body = robot.bodies[static_cast<std::size_t>(link.body)];
    link.orientation = body.orientation.normalized();
    const Eigen::Matrix3d frame = link.orientation.toRotationMatrix();
    const InertiaSpec& I = body.inertia;
    Eigen::Matrix3d own;
    own << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
    link.mass = body.mass;
    link.com = body.position + frame * body.com;
    link.inertia = frame * own * frame.transpose();
    if (joint_of_link_[i] < 0) continue;
    const JointSpec& joint = robot.joints[static_cast<std::size_t>(joint_of_link_[i])];
    link.anchor = joint.anchor;
    link.axes = {joint.axis.normalized(), joint.axis2.normalized()};
    link.parent_frame.setIdentity();
    if (link.parent >= 0)
      link.parent_frame = robot.bodies[static_cast<std::size_t>(links_[static_cast<std::size_t>(link.parent)].body)]
                              .orientation.normalized()
                              .toRotationMatrix();
  }
}

void Tree::drift(std::span<const double> velocities, double time, std::span<double> configuration) const {
  for (const Link& link : links_) {
    const double* v = velocities.data() + link.dof;
    double* q = configuration.data() + link.position;
    if (link.kind == LinkKind::ball) {
      turn_at(q, time * Vector3d(v[0], v[1], v[2]));
    } else if (link.kind == LinkKind::floating) {
      for (int i = 0; i < 3; ++i) q[i] += time * v[i];
      turn_at(q + 3, time * Vector3d(v[3], v[4], v[5]));
    } else {
      for (int i = 0; i < link.dofs; ++i) q[i] += time * v[i];
    }
  }
}

void Tree::begin(const RobotSpec& robot, std::span<const double> coordinates, std::span<const double> rates,
                 std::span<double> configuration, std::span<double> velocities) const {
  std::fill(velocities.begin(), velocities.end(), 0.0);
  for (std::size_t c = 0; c < rates.size(); ++c) velocities[dof_of_coordinate_[c]] = rates[c];
  std::vector<double> values(dofs_, 0.0);
  for (std::size_t c = 0; c < coordinates.size(); ++c) values[dof_of_coordinate_[c]] = coordinates[c];
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const double* from = values.data() + link.dof;
    double* q = configuration.data() + link.position;
    if (link.kind == LinkKind::floating) {
      const BodySpec& body = robot.bodies[static_cast<std::size_t>(link.body)];
      const Vector3d com = body.position + body.orientation.normalized() * body.com;
      for (int axis = 0; axis < 3; ++axis) q[axis] = com[axis] + from[axis];
      put(turn_by(Vector3d(from[3], from[4], from[5])), q + 3);
    } else if (link.kind == LinkKind::ball) {
      put(turn_by(Vector3d(from[0], from[1], from[2])), q);
    } else {
      std::copy(from, from + link.dofs, q);
    }
  }
}

void Tree::coordinates(std::span<const double> configuration, std::span<double> out) const {
  for (std::size_t c = 0; c < out.size();) {
    const std::size_t dof = dof_of_coordinate_[c];
    const auto link = std::find_if(links_.begin(), links_.end(), [&](const Link& one) {
      return dof >= static_cast<std::size_t>(one.dof) && dof < nth(one.dof, one.dofs);
    });
    const double* q = configuration.data() + link->position;
    if (link->kind == LinkKind::ball) {
      const Vector3d turn = rotation_vector(quaternion_at(q));
      std::copy(turn.begin(), turn.end(), out.begin() + static_cast<std::ptrdiff_t>(c));
    } else if (link->kind == LinkKind::floating) {
      const Vector3d turn = rotation_vector(quaternion_at(q + 3));
      for (std::size_t i = 0; i < 3; ++i) {
        out[c + i] = q[i] - link->com[static_cast<Eigen::Index>(i)];
        out[c + 3 + i] = turn[static_cast<Eigen::Index>(i)];
      }
    } else {
      std::copy(q, q + link->dofs, out.begin() + static_cast<std::ptrdiff_t>(c));
    }
    c += static_cast<std::size_t>(link->dofs);
  }
}

}  // namespace lacuna::articulated
