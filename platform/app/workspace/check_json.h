#pragma once

#include "app/workspace/open_experiment.h"

#include <string>

namespace lacuna {

/// What `check_summary` prints, as JSON: robot, free values, effects, trials, channels with their ranges in SI units,
/// setups, and notes with their places. `database`: where results of the experiment are kept unless `--db` says else.
std::string check_json(const OpenExperiment& opened, const std::string& database);

}  // namespace lacuna
