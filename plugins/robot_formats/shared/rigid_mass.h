#pragma once

#include <lacuna/robot_spec.h>

#include <vector>

namespace lacuna::robot_files {

/// A frame relative to another.
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

/// Inertia that a mass adds about a point at a distance `away` from it.
Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& away);

/// Total of parts that move together, all in one frame.
RigidMass joined(const std::vector<RigidMass>& parts);

/// A whole minus a part of it, both in one frame; the whole is heavier.
RigidMass without(const RigidMass& whole, const RigidMass& part);

/// Transformed from a frame at `pose` in another into that other.
RigidMass moved(const RigidMass& mass, const Pose& pose);

InertiaSpec spec_of(const Eigen::Matrix3d& inertia);
Eigen::Matrix3d matrix_of(const InertiaSpec& inertia);

/// A body with that mass, whose frame is at `pose` in the world.
BodySpec body_of(const std::string& name, const RigidMass& mass, const Pose& pose);

/// Why a body cannot be simulated: its numbers, or what was computed of them, are too large. Empty: it can.
std::string why_too_large(const BodySpec& body);

}  // namespace lacuna::robot_files
