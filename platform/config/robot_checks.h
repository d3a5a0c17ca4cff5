#pragma once

#include "config/locations.h"
#include "config/reading.h"
#include "config/robot_file.h"

namespace lacuna {

/// What concerns several parts of a robot at once: names that must exist, joints that form a
/// forest, gains and elements that suit a kind. Adds problems only, and none to an element that
/// `reading` has found problems in already.
void check_robot(const RobotInFile& file, const Locations& locations, Reading& reading);

}  // namespace lacuna
