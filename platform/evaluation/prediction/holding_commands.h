#pragma once

#include "simulation/compiled_model.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// The commands that hold a robot at rest: constant, long since given, at joint coordinates `positions` they leave
/// every velocity at zero. Of a robot that friction or a brake holds without them they are zero, and of several that
/// hold it they are the smallest. `known`: by channel of `channels`, NaN where it is sought; in the unit of the
/// commands, SI; `setup`: the rig's. Nothing where no commands hold it, or it cannot be simulated. Found by
/// Gauss-Newton steps on the velocities after a single integration step, which are linear in the commands but for
/// friction and limits.
std::optional<std::vector<double>> holding_commands(const CompiledModel& model, std::span<const double> values,
                                                    const std::vector<Channel>& channels, std::vector<double> known,
                                                    const std::vector<double>& positions, const std::string& setup,
                                                    Workspace& workspace);

}  // namespace lacuna
