#pragma once

#include <lacuna/robot_spec.h>

#include <vector>

namespace lacuna::robot_files {

/// A frame in another.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

  Pose operator*(const Pose& inner) const {
    return {position + orientation * inner.position, orientation * inner.orientation};
  }
  Pose inverse() const { return {orientation.conjugate() * -position, orientation.conjugate()}; }
};

/// Mass, kg, its centre, m, and the inertia about the centre along the axes of the frame, kg·m².
struct RigidMass {
  double mass = 0.0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// What a mass elsewhere adds to the inertia about a point `away` from it.
Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& away);

/// Of parts that move together, all in one frame.
RigidMass joined(const std::vector<RigidMass>& parts);

/// What is left of a whole without a part of it, both in one frame; the whole weighs more.
RigidMass without(const RigidMass& whole, const RigidMass& part);

/// Of a frame that stands at `pose` in another: seen from that other.
RigidMass moved(const RigidMass& mass, const Pose& pose);

InertiaSpec spec_of(const Eigen::Matrix3d& inertia);
Eigen::Matrix3d matrix_of(const InertiaSpec& inertia);

/// A body with that mass, whose frame stands at `pose` in the world.
BodySpec body_of(const std::string& name, const RigidMass& mass, const Pose& pose);

}  // namespace lacuna::robot_files
