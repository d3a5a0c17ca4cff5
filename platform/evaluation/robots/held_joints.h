#pragma once

#include "config/schema/experiment.h"
#include "foundation/text/problem.h"

#include <string>

namespace lacuna {

/// Makes the joints that `[model] held` names stand still at position zero: they become fixed, and their actuators and
/// sensors go. `key` is the section's. Adds a problem for a pattern that names no joint, and for a joint that another
/// one follows, which would not know where to stand.
void hold_joints(RobotSpec& robot, const Experiment& experiment, const ModelSection& section, const std::string& key,
                 ProblemList& problems);

}  // namespace lacuna
