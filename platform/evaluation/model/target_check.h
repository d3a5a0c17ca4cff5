#pragma once

#include "evaluation/model/complaints.h"

#include <lacuna/robot_spec.h>

namespace lacuna {

/// Checks an experiment's target and disturbances against the robot: elements must exist, and numbers must have the
/// units of their channels and joints.
void check_target(const RobotSpec& robot, const Experiment& experiment, Complaints& complaints);

}  // namespace lacuna
