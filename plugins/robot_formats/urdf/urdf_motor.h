#pragma once

#include "urdf_file.h"

namespace lacuna::urdf {

/// The drive of a joint. Without any command interface in the file (`says_commands`): a force or torque. Else according
/// to the joint's command interfaces; of several the effort, because it needs no servo. Nothing where the joint has
/// none.
std::optional<ActuatorSpec> motor_of(const Joint& joint, bool says_commands, std::vector<RobotRemark>& remarks);

}  // namespace lacuna::urdf
