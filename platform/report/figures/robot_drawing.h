#pragma once

#include <lacuna/robot_spec.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// A robot in the pose in which it starts, as it is drawn.
struct DrawnRobot {
  std::string caption;
  RobotSpec robot;
};

/// Robots side by side, with what they have in common beside them.
struct RobotRow {
  std::string label;
  std::vector<DrawnRobot> robots;
};

/// Draws robots of cylinders and capsules from above at a slant: each part a thick line in a colour of its own, by
/// index, on a grid of 1 m that is the ground, which has range beacons on it as dots. What of a part is below the
/// ground is pale; a legend says all that. All have one scale, but those that reach far beyond the grid are drawn
/// smaller, which their captions say. Rows begin with their labels. Replaces the file at once; throws `Error` where it
/// cannot be written.
void write_robots_svg(const std::string& title, const std::vector<RobotRow>& rows, const std::filesystem::path& file);

}  // namespace lacuna
