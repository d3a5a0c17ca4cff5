#pragma once

#include "simulation/compiled_model.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// The constant commands that hold a robot at rest at joint coordinates `positions`: all velocities stay zero. If
/// friction or a brake holds the robot without commands they are zero; of several solutions they are the smallest.
/// `known`: by channel of `channels`, NaN for an unknown one; in the unit of the commands, SI; `setup`: the rig's.
/// Nothing where no commands hold it, or it cannot be simulated. Found by Gauss-Newton steps on the velocities after a
/// single integration step, which are linear in the commands except for friction and limits.
std::optional<std::vector<double>> holding_commands(const CompiledModel& model, std::span<const double> values,
                                                    const std::vector<Channel>& channels, std::vector<double> known,
                                                    const std::vector<double>& positions, const std::string& setup,
                                                    Workspace& workspace);

}  // namespace lacuna
