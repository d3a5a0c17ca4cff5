#pragma once

#include <lacuna/robot_spec.h>

#include <vector>

namespace lacuna {

/// A hinge whose coordinate is part of a link's angle.
struct LinkTurn {
  int joint = 0;      ///< index into the robot's
  double sign = 1.0;  ///< of its coordinate in the angle
};

/// The angle of the child of hinge `joint` about its axis is the sum of the coordinates of these hinges: those between
/// it and the world, whose axes are parallel. Throws `Error` where `joint` is not a hinge, or another joint in between
/// turns the link about another axis.
std::vector<LinkTurn> turns_of_link(const RobotSpec& robot, const std::string& joint);

}  // namespace lacuna
