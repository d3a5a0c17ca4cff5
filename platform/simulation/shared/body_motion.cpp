#include "simulation/shared/body_motion.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace lacuna::simulation {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Displacement of a body from its zero pose, as a rigid motion of the world's points, and its velocity there: point p
/// of the zero configuration is at rotation·p + shift.
struct Displacement {
  Matrix3d rotation = Matrix3d::Identity();
  Vector3d shift{0.0, 0.0, 0.0};
  Vector3d angular_velocity{0.0, 0.0, 0.0};
  Vector3d origin_velocity{0.0, 0.0, 0.0};  ///< of the body's point that is currently at the world's origin

  Vector3d moved(const Vector3d& zero_point) const { return rotation * zero_point + shift; }
  Vector3d velocity_at(const Vector3d& point) const { return origin_velocity + angular_velocity.cross(point); }
};

/// The joint's own motion, in world coordinates of the zero configuration.
struct JointMotion {
  Matrix3d rotation = Matrix3d::Identity();
  Vector3d translation{0.0, 0.0, 0.0};
  Vector3d angular_velocity{0.0, 0.0, 0.0};
  Vector3d velocity{0.0, 0.0, 0.0};
};

Matrix3d exponential(const Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  return angle > 0.0 ? AngleAxisd(angle, rotation_vector / angle).toRotationMatrix() : Matrix3d::Identity();
}

JointMotion motion_of(const JointSpec& joint, const Matrix3d& parent_frame, const double* q, const double* v) {
  const Vector3d axis = joint.axis.normalized();
  JointMotion motion;
  switch (joint.kind) {
    case JointKind::hinge:
      motion.rotation = AngleAxisd(q[0], axis).toRotationMatrix();
      motion.angular_velocity = axis * v[0];
      break;
    case JointKind::slider:
      motion.translation = axis * q[0];
      motion.velocity = axis * v[0];
      break;
    case JointKind::universal: {
      const Vector3d axis2 = joint.axis2.normalized();
      const Matrix3d first = AngleAxisd(q[0], axis).toRotationMatrix();
      motion.rotation = first * AngleAxisd(q[1], axis2).toRotationMatrix();
      motion.angular_velocity = axis * v[0] + first * axis2 * v[1];
      break;
    }
    case JointKind::ball:
      motion.rotation = exponential(parent_frame * Vector3d(q[0], q[1], q[2]));
      motion.angular_velocity = parent_frame * Vector3d(v[0], v[1], v[2]);
      break;
    case JointKind::free:
      motion.translation = Vector3d(q[0], q[1], q[2]);
      motion.rotation = exponential(Vector3d(q[3], q[4], q[5]));
      motion.velocity = Vector3d(v[0], v[1], v[2]);
      motion.angular_velocity = Vector3d(v[3], v[4], v[5]);
      break;
    case JointKind::fixed: break;
  }
  return motion;
}

/// In the zero configuration, world.
Vector3d centre_of_mass(const BodySpec& body) { return body.position + body.orientation.normalized() * body.com; }

/// Adds a joint's motion to its parent's displacement.
Displacement compose(const Displacement& parent, const JointMotion& motion, const Vector3d& anchor) {
  Displacement child;
  child.rotation = parent.rotation * motion.rotation;
  child.shift = parent.moved(anchor + motion.translation) - child.rotation * anchor;
  child.angular_velocity = parent.angular_velocity + parent.rotation * motion.angular_velocity;
  const Vector3d pivot = parent.moved(anchor + motion.translation);
  const Vector3d pivot_velocity = parent.velocity_at(pivot) + parent.rotation * motion.velocity;
  child.origin_velocity = pivot_velocity - child.angular_velocity.cross(pivot);
  return child;
}

}  // namespace

void place_bodies(const RobotSpec& robot, const JointTree& tree, const StartState& start,
                  std::span<BodyMotion> bodies) {
  static constexpr std::array<double, 6> kZero{};
  std::vector<Displacement> displacements(robot.bodies.size());
  const Displacement still;
  for (const int index : tree.outward) {
    const auto joint = static_cast<std::size_t>(index);
    const auto first = static_cast<std::size_t>(tree.first_coordinate[joint]);
    const bool held_by_world = tree.parent[joint] == kWorldIndex;
    const auto parent = static_cast<std::size_t>(tree.parent[joint]);
    const Matrix3d parent_frame =
        held_by_world ? Matrix3d::Identity() : robot.bodies[parent].orientation.normalized().toRotationMatrix();
    const double* q = start.positions.empty() ? kZero.data() : start.positions.data() + first;
    const double* v = start.velocities.empty() ? kZero.data() : start.velocities.data() + first;
    const JointMotion motion = motion_of(robot.joints[joint], parent_frame, q, v);
    const auto child = static_cast<std::size_t>(tree.child[joint]);
    const Vector3d anchor =
        robot.joints[joint].kind == JointKind::free ? centre_of_mass(robot.bodies[child]) : robot.joints[joint].anchor;
    displacements[child] = compose(held_by_world ? still : displacements[parent], motion, anchor);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodySpec& body = robot.bodies[i];
    const Displacement& displacement = displacements[i];
    const Eigen::Quaterniond zero = body.orientation.normalized();
    bodies[i].orientation = Eigen::Quaterniond(displacement.rotation) * zero;
    bodies[i].position = displacement.moved(body.position + zero * body.com);
    bodies[i].angular_velocity = displacement.angular_velocity;
    bodies[i].velocity = displacement.velocity_at(bodies[i].position);
  }
}

}  // namespace lacuna::simulation
