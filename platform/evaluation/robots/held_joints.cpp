#include "evaluation/robots/held_joints.h"

#include "foundation/address.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace lacuna {
namespace {

JointSpec standing(const JointSpec& joint) {
  JointSpec fixed;
  fixed.name = joint.name;
  fixed.kind = JointKind::fixed;
  fixed.parent = joint.parent;
  fixed.child = joint.child;
  fixed.anchor = joint.anchor;
  fixed.axis = joint.axis;
  return fixed;
}

/// Its element is a joint, not a body, which may have the same name.
bool reads_joint(const SensorSpec& sensor) {
  switch (sensor.kind) {
    case SensorKind::joint_position:
    case SensorKind::joint_velocity:
    case SensorKind::joint_force:
    case SensorKind::drive_force:
    case SensorKind::link_angle:
    case SensorKind::link_velocity: return true;
    default: return false;
  }
}

std::set<std::string> joints_held(const RobotSpec& robot, const Experiment& experiment, const ModelSection& section,
                                  const std::string& key, ProblemList& problems) {
  std::set<std::string> held;
  for (std::size_t i = 0; i < section.held.size(); ++i) {
    bool found = false;
    for (const JointSpec& joint : robot.joints) {
      if (!matches(section.held[i], "joint." + joint.name)) continue;
      held.insert(joint.name);
      found = true;
    }
    if (!found)
      problems.add(experiment.where(fmt::format("{}.held[{}]", key, i)),
                   fmt::format("the robot has no joint \"{}\"; write one such as \"joint.{}\"", section.held[i],
                               robot.joints.empty() ? "NAME" : robot.joints.front().name));
  }
  return held;
}

}  // namespace

void hold_joints(RobotSpec& robot, const Experiment& experiment, const ModelSection& section, const std::string& key,
                 ProblemList& problems) {
  const std::set<std::string> held = joints_held(robot, experiment, section, key, problems);
  for (const CouplingSpec& coupling : robot.couplings)
    if (held.contains(coupling.joint) != held.contains(coupling.follows))
      problems.add(experiment.where(key + ".held"),
                   fmt::format("joints {} and {} move together, but only one of them is held; hold both",
                               coupling.joint, coupling.follows));
  std::erase_if(robot.couplings, [&](const CouplingSpec& one) { return held.contains(one.joint); });
  std::erase_if(robot.actuators, [&](const ActuatorSpec& one) { return held.contains(one.joint); });
  std::erase_if(robot.sensors, [&](const SensorSpec& one) { return reads_joint(one) && held.contains(one.element); });
  for (JointSpec& joint : robot.joints)
    if (held.contains(joint.name)) joint = standing(joint);
}

}  // namespace lacuna
