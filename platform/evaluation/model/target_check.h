#pragma once

#include "evaluation/model/complaints.h"

#include <lacuna/robot_spec.h>

namespace lacuna {

/// Whether what an experiment says of its target and its disturbances fits the robot: elements that
/// exist, and numbers written in the units of the channels and joints that they belong to.
void check_target(const RobotSpec& robot, const Experiment& experiment, Complaints& complaints);

}  // namespace lacuna
