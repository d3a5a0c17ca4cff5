#pragma once

#include "data_checks/command_lags.h"

#include <vector>

namespace lacuna {

/// Checks trials against each other: shifted time stamps; another rig. Both need two trials. With only two, the wrong
/// one cannot be named.
std::vector<DataWarning> trial_checks(const AccelerationTable& table, const CommandLags& lags);

}  // namespace lacuna
