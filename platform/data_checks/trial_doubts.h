#pragma once

#include "data_checks/command_lags.h"

#include <vector>

namespace lacuna {

/// Of trials against each other: one whose time stamps are shifted, one that is of another rig. Both need two trials,
/// and where there are only two, none can be named.
std::vector<Doubt> trial_doubts(const AccelerationTable& table, const CommandLags& lags);

}  // namespace lacuna
