#pragma once

#include "data_checks/acceleration_table.h"

#include <optional>

namespace lacuna {

/// Where the model explains almost none of the measured accelerations, checks whether it explains them with the
/// readings in another unit: degrees, or thousandths. A wrong factor of a linear model is found by the response to
/// commands instead (command_checks.h); this check finds a factor that gravity or a swing over the top hides from the
/// other.
std::optional<DataWarning> unit_doubt(const DataCheckTask& task, const AccelerationTable& table,
                                      const std::vector<ChannelNoise>& noise);

}  // namespace lacuna
