#pragma once

#include "config/schema/experiment.h"
#include "foundation/text/problem.h"

#include <string>
#include <vector>

namespace lacuna {

/// Makes an actuator take forces, positions or velocities, whatever its file says. A servo that the file did not have
/// gets gains that put out its whole force (10 N*m or N where that is not known) for an error of 0.1 rad or m, and a
/// damping of 0.1 s times its stiffness; they are the start of a fit.
void set_drive(ActuatorSpec& actuator, ActuatorKind kind);

/// The same of all actuators that `section.drive` names; `key`: "model". A pattern that names none is a problem.
void set_drives(RobotSpec& robot, const Experiment& experiment, const ModelSection& section, const std::string& key,
                ProblemList& problems);

}  // namespace lacuna
