#pragma once

#include "config/toml/locations.h"
#include "config/toml/reading.h"
#include "config/schema/robot_file.h"

namespace lacuna {

/// What concerns several parts of a robot at once: names that must exist, joints that form a
/// forest, gains and elements that suit a kind. Adds problems only, and none to an element that
/// `reading` has found problems in already.
void check_robot(const RobotInFile& file, const Locations& locations, Reading& reading);

}  // namespace lacuna
