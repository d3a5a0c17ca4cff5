#pragma once

#include "data_checks/command_lags.h"

#include <vector>

namespace lacuna {

/// Of commands against what they do: motion that is many times too large or too small for them (units), that goes
/// against them, that does not follow them, or that comes before them, as where a command column is a measurement.
std::vector<Doubt> command_doubts(const DoubtTask& task, const AccelerationTable& table, const CommandLags& lags);

/// Of command columns alone: one that is nothing but what is measured at the same moment, noise included; one that
/// contains the noise of a reading, as a controller's does (a note).
std::vector<Doubt> feedback_doubts(const DoubtTask& task);

}  // namespace lacuna
