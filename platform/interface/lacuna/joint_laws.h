#pragma once

#include <lacuna/error.h>
#include <lacuna/robot_spec.h>

#include <cstddef>

namespace lacuna {

/// For effects that amend a joint's laws (damping, dry friction, stiffness, force) by one value: the joint. Throws
/// `Error` for a fixed joint, which has no coordinate, and for a ball joint: one dry friction in each of its three
/// coordinates would be larger about their diagonal than about an axis, and one force would have a direction that
/// nobody chose.
inline JointSpec& joint_with_laws(RobotSpec& robot, int joint) {
  JointSpec& spec = robot.joints[static_cast<std::size_t>(joint)];
  if (spec.kind == JointKind::fixed || spec.kind == JointKind::ball)
    throw Error("joint." + spec.name + " is a " + (spec.kind == JointKind::fixed ? "fixed" : "ball") +
                " joint; place the effect on hinges, sliders and universal joints");
  return spec;
}

}  // namespace lacuna
