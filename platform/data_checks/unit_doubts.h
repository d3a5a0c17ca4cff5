#pragma once

#include "data_checks/acceleration_table.h"

#include <optional>

namespace lacuna {

/// Where the model explains next to nothing of the measured accelerations, whether it explains them once the readings
/// are taken to be in another unit: degrees, or thousandths. A model that is wrong by that factor in a linear way is
/// found by the response to commands instead (command_doubts.h); this finds what gravity or a swing over the top hides
/// from it.
std::optional<Doubt> unit_doubt(const DoubtTask& task, const AccelerationTable& table,
                                const std::vector<ChannelNoise>& noise);

}  // namespace lacuna
