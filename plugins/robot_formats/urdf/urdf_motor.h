#pragma once

#include "urdf_file.h"

namespace lacuna::urdf {

/// What drives a joint. Nothing says so (`says_commands`): a force or torque. Else what its command interfaces say; of
/// several the effort, for it needs no servo that nobody describes. Nothing where the joint has none.
std::optional<ActuatorSpec> motor_of(const Joint& joint, bool says_commands, std::vector<RobotRemark>& remarks);

}  // namespace lacuna::urdf
