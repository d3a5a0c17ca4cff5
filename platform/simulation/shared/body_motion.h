#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/test.h>

#include "simulation/shared/joint_tree.h"

#include <span>

namespace lacuna::simulation {

/// Pose and velocity of a body in the world, at its centre of mass; SI.
struct BodyMotion {
  Eigen::Vector3d position{0.0, 0.0, 0.0};
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity{0.0, 0.0, 0.0};
  Eigen::Vector3d angular_velocity{0.0, 0.0, 0.0};
};

/// Forward kinematics: positions and velocities of the bodies for the given joint coordinates (empty: zero). Floating
/// bodies are at their pose in the spec, at rest. The velocities of a ball joint are the child's angular velocity
/// relative to the parent, in the parent frame.
void place_bodies(const RobotSpec& robot, const JointTree& tree, const StartState& start, std::span<BodyMotion> bodies);

}  // namespace lacuna::simulation
