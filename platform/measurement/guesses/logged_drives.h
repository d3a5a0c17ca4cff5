#pragma once

#include "measurement/guesses/file_sample.h"
#include "measurement/guesses/column_guess.h"

#include <lacuna/robot_spec.h>

#include <optional>
#include <vector>

namespace lacuna {

/// What a robot's joints were commanded in, by what was logged, where that is not what all of its actuators take:
/// positions where goals for positions were logged and no torques, forces where these were logged and no goals. Nothing
/// where the recordings do not tell. `robot`: with actuators of one kind.
std::optional<ActuatorKind> logged_drive(const FileSample& sample, const ColumnHints& hints, const RobotSpec& robot);

}  // namespace lacuna
