#include "simulation/articulated/random_tree.h"

#include <array>
#include <string>

namespace lacuna {
namespace {

/// Of a body with mass in all directions, about its centre of mass.
InertiaSpec random_inertia(Draws& draws) {
  Eigen::Matrix3d spread;
  for (double& element : spread.reshaped()) element = 0.1 * draws.number();
  const Eigen::Matrix3d squares = spread * spread.transpose() + 0.02 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d inertia = squares.trace() * Eigen::Matrix3d::Identity() - squares;
  return {.xx = inertia(0, 0),
          .yy = inertia(1, 1),
          .zz = inertia(2, 2),
          .xy = inertia(0, 1),
          .xz = inertia(0, 2),
          .yz = inertia(1, 2)};
}

BodySpec random_body(int number, Draws& draws) {
  BodySpec body;
  body.name = "body" + std::to_string(number);
  body.mass = 0.5 + 0.4 * draws.number();
  body.inertia = random_inertia(draws);
  body.position = draws.vector();
  body.orientation = draws.turn();
  body.com = 0.2 * draws.vector();
  return body;
}

JointSpec random_joint(const std::string& parent, const std::string& child, Draws& draws) {
  constexpr std::array<JointKind, 4> kKinds = {JointKind::hinge, JointKind::slider, JointKind::universal,
                                               JointKind::ball};
  JointSpec joint;
  joint.name = "joint_of_" + child;
  joint.kind = kKinds[static_cast<std::size_t>(draws.below(4))];
  joint.parent = parent;
  joint.child = child;
  joint.anchor = draws.vector();
  joint.axis = draws.vector().normalized();
  joint.axis2 = joint.axis.cross(draws.vector()).normalized();
  return joint;
}

}  // namespace

Eigen::Vector3d Draws::vector() {
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

Eigen::Quaterniond Draws::turn() {
  const double w = number();
  const Eigen::Vector3d axis = vector();
  return Eigen::Quaterniond(w, axis.x(), axis.y(), axis.z()).normalized();
}

RandomTree random_tree(int bodies, bool floating, Draws& draws) {
  RandomTree tree;
  tree.robot.gravity = {0.3, -0.2, -9.81};
  for (int i = 0; i < bodies; ++i) {
    tree.parents.push_back(i == 0 ? -1 : draws.below(i));
    tree.robot.bodies.push_back(random_body(i, draws));
    if (i == 0 && floating) continue;
    const std::string parent = i == 0 ? kWorld : tree.robot.bodies[static_cast<std::size_t>(tree.parents.back())].name;
    tree.robot.joints.push_back(random_joint(parent, tree.robot.bodies.back().name, draws));
  }
  return tree;
}

}  // namespace lacuna
