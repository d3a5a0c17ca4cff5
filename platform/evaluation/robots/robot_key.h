#pragma once

#include <lacuna/robot_spec.h>

#include <string>

namespace lacuna {

/// Adds to `key` every number and name of a robot, so that no simulation can distinguish robots with the same key.
void append_key(const RobotSpec& robot, std::string& key);

/// Why a robot from a model encoding cannot replace the experiment's: a body, joint, actuator or sensor that only one
/// of them has, in another order or of another kind, or a sensor or actuator on a joint of another kind, which would
/// have other channels. Empty: it can.
std::string misfit(const RobotSpec& built, const RobotSpec& of_experiment);

}  // namespace lacuna
