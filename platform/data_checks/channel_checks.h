#pragma once

#include "data_checks/data_warning.h"

#include <vector>

namespace lacuna {

/// Checks the amount of data: too few stretches for a chance below one in a hundred, a single fit trial, no held-out
/// trial.
std::vector<DataWarning> amount_doubts(const DataCheckTask& task);

/// Checks single channels that measure a joint's position or velocity: constant, saturated, or more scatter than
/// motion.
std::vector<DataWarning> channel_checks(const DataCheckTask& task);

/// Whether a sensor of the joint reaches the end of its range in this trial.
bool is_saturated(const RobotSpec& robot, const Trial& trial);

}  // namespace lacuna
