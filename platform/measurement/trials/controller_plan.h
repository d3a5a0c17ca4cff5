#pragma once

#include "measurement/trials/trial_builder.h"

namespace lacuna {

/// Matches the declared control laws with the robot's channels and with the columns of the plan, and adds the columns
/// of their references. An actuator without a command column, a sensor that is not measured and gains in other units
/// are problems.
void plan_controllers(const std::vector<ControllerMapping>& controllers, const std::vector<Channel>& channels,
                      const std::vector<Channel>& actuators, RecordingPlan& plan, ProblemList& problems);

}  // namespace lacuna
