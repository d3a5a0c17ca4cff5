#pragma once

#include <lacuna/error.h>
#include <lacuna/physical_effect.h>
#include <lacuna/robot_spec.h>

#include <cstddef>

namespace lacuna {

/// For effects that amend a joint's laws (damping, dry friction, stiffness, force) by one value: the joint at an index.
/// Throws `Error` for a fixed joint, which has no coordinate, and for a ball joint: the same dry friction in each of
/// its three coordinates would be larger about their diagonal than about an axis, and one force would have an arbitrary
/// direction.
inline JointSpec& joint_with_laws(RobotSpec& robot, int joint) {
  JointSpec& spec = robot.joints[static_cast<std::size_t>(joint)];
  if (spec.kind == JointKind::fixed || spec.kind == JointKind::ball || spec.kind == JointKind::free)
    throw Error("joint." + spec.name + " is a " +
                (spec.kind == JointKind::fixed  ? "fixed"
                 : spec.kind == JointKind::ball ? "ball"
                                                : "free") +
                " joint; place the effect on hinges, sliders and universal joints");
  return spec;
}

/// For effects that act on the one coordinate of a joint in each step: the same, but universal joints are refused, too.
inline JointSpec& joint_with_one_coordinate(RobotSpec& robot, int joint) {
  JointSpec& spec = joint_with_laws(robot, joint);
  if (spec.kind == JointKind::universal)
    throw Error("joint." + spec.name +
                " is a universal joint, which has two coordinates; place the effect on hinges and sliders");
  return spec;
}

/// The coordinate of a joint with one coordinate.
inline std::size_t coordinate_of(const StepView& view, int joint) {
  return static_cast<std::size_t>(view.first_coordinate[static_cast<std::size_t>(joint)]);
}

}  // namespace lacuna
