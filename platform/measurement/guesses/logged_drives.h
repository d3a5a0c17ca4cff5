#pragma once

#include "measurement/guesses/file_sample.h"
#include "measurement/guesses/column_guess.h"

#include <lacuna/robot_spec.h>

#include <optional>
#include <vector>

namespace lacuna {

/// The kind of command of a robot's joints according to the recordings, where it differs from that of its actuators:
/// positions where position setpoints were logged and no torques, forces where these were logged and no setpoints.
/// Nothing where the recordings do not show it. `robot`: with actuators of one kind.
std::optional<ActuatorKind> logged_drive(const FileSample& sample, const ColumnHints& hints, const RobotSpec& robot);

}  // namespace lacuna
