#pragma once

#include "plugin_checks/transcript.h"

#include <lacuna/robot_spec.h>

namespace lacuna {

/// All of a robot that a definition or a format makes.
void write_down_robot(const char* call, const RobotSpec& robot, Transcript& transcript);

}  // namespace lacuna
