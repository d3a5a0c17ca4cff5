#include "foundation/link_angle.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kParallel = 1e-6;  ///< largest deviation of the axes' cosine from ±1

std::vector<JointSpec>::const_iterator holder_of(const RobotSpec& robot, const std::string& body) {
  return std::find_if(robot.joints.begin(), robot.joints.end(),
                      [&](const JointSpec& joint) { return joint.child == body; });
}

}  // namespace

std::vector<LinkTurn> turns_of_link(const RobotSpec& robot, const std::string& name) {
  const auto read = std::find_if(robot.joints.begin(), robot.joints.end(),
                                 [&](const JointSpec& joint) { return joint.name == name; });
  if (read == robot.joints.end() || read->kind != JointKind::hinge)
    throw Error("joint." + name + " is not a hinge, so its link has no angle");
  const Eigen::Vector3d axis = read->axis.normalized();
  std::vector<LinkTurn> turns;
  for (auto joint = read; joint != robot.joints.end() && turns.size() <= robot.joints.size();
       joint = holder_of(robot, joint->parent)) {
    const double cosine = joint->axis.normalized().dot(axis);
    if (joint->kind == JointKind::fixed || joint->kind == JointKind::slider) continue;
    if (joint->kind != JointKind::hinge || std::abs(std::abs(cosine) - 1.0) > kParallel)
      throw Error("the link of joint." + name + " is turned by joint." + joint->name +
                  " about another axis, so it has no angle; read the joint's position");
    turns.push_back({static_cast<int>(joint - robot.joints.begin()), cosine > 0.0 ? 1.0 : -1.0});
  }
  return turns;
}

}  // namespace lacuna
