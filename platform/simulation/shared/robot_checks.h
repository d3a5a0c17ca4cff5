#pragma once

#include <lacuna/engine_settings.h>
#include <lacuna/robot_spec.h>

#include <string>

namespace lacuna::simulation {

/// Throws `BadInput` with everything that prevents the robot from being compiled, except the shape of its joint tree
/// (`make_joint_tree`): repeated names, elements that do not exist, actuators on joints that cannot have one, axes,
/// masses, inertias, sizes and values out of bounds.
void check_robot(const RobotSpec& robot);

/// Throws `BadInput` for settings with which no simulation can run.
void check_settings(const EngineSettings& settings);

/// Why the robot's numbers, as amended for one simulation, are unphysical: a sentence, or empty. Costs far less than
/// `check_robot`.
std::string unphysical(const RobotSpec& robot);

}  // namespace lacuna::simulation
