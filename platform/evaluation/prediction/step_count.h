#pragma once

#include <lacuna/trial.h>

#include "config/schema/experiment.h"

#include <string>
#include <vector>

namespace lacuna {

/// Largest number of integration steps of one simulation: more take minutes, and every command simulates hundreds of
/// times.
inline constexpr double kMostSteps = 1e8;

/// Throws `BadInput` at `engine.step` where one simulation of `duration` s needs more steps than that. `what` names the
/// simulation: "of fit.csv".
void check_step_count(const Experiment& experiment, double duration, const std::string& what);

/// The same for the longest of the trials and, where the target takes tests, for a test; with the finer steps of a
/// simulated target, if it has any.
void check_step_count(const Experiment& experiment, const std::vector<Trial>& trials, bool takes_tests);

}  // namespace lacuna
