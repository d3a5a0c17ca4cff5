#pragma once

#include "data_checks/command_lags.h"

#include <vector>

namespace lacuna {

/// Checks commands against the motion: motion many times too large or too small for its commands (units), against its
/// commands, independent of them, or before them, as where a command column is a measurement.
std::vector<DataWarning> command_checks(const DataCheckTask& task, const AccelerationTable& table,
                                        const CommandLags& lags);

/// Checks command columns alone: one that equals the measurement of the same moment including its noise (a fault); one
/// that contains the noise of a reading, as a controller's command does (a note).
std::vector<DataWarning> feedback_checks(const DataCheckTask& task);

}  // namespace lacuna
