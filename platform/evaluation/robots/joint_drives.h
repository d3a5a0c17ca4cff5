#pragma once

#include "config/schema/experiment.h"
#include "foundation/text/problem.h"

#include <string>
#include <vector>

namespace lacuna {

/// Makes an actuator take forces, positions or velocities, whatever its file says. A servo that is not in the file gets
/// gains that give its full force (10 N*m or N where that is not known) for an error of 0.1 rad or m, and a damping of
/// 0.1 s times its stiffness; these are start values for a fit.
void set_drive(ActuatorSpec& actuator, ActuatorKind kind);

/// The same for all actuators that `section.drive` names; `key`: "model". A pattern without a match is a problem.
void set_drives(RobotSpec& robot, const Experiment& experiment, const ModelSection& section, const std::string& key,
                ProblemList& problems);

}  // namespace lacuna
