#pragma once

#include "data_checks/doubt.h"

#include <vector>

namespace lacuna {

/// Of the amount of data: too few stretches for a chance below one in a hundred, a single trial, nothing held out.
std::vector<Doubt> amount_doubts(const DoubtTask& task);

/// Of single channels that measure a joint's position or velocity: constant, saturated, or more scatter than motion.
std::vector<Doubt> channel_doubts(const DoubtTask& task);

/// Whether a joint's reading ends at the limit of its range in this trial.
bool is_saturated(const RobotSpec& robot, const Trial& trial);

}  // namespace lacuna
