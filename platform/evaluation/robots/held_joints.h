#pragma once

#include "config/schema/experiment.h"
#include "foundation/text/problem.h"

#include <string>

namespace lacuna {

/// Holds the joints that `[model] held` names at position zero: they become fixed, and their actuators and sensors are
/// removed. `key` is the section's. Adds a problem for a pattern that matches no joint, and for a joint that another
/// one follows.
void hold_joints(RobotSpec& robot, const Experiment& experiment, const ModelSection& section, const std::string& key,
                 ProblemList& problems);

}  // namespace lacuna
