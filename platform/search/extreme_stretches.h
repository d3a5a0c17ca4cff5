#pragma once

#include "prediction/prediction_ladder.h"

#include <string>
#include <vector>

namespace lacuna {

/// The joint of "joint.hinge", "actuator.motor" or "sensor.angle", or of a value there; otherwise empty.
std::string joint_at(const RobotSpec& robot, const std::string& where);

/// The stretches by which effects are sized: a few of the middle length, and the extremes of the effect's joint.
PredictionLadder for_sizes(const PredictionLadder& ladder, const RobotSpec& robot, const std::vector<Trial>& trials,
                           const std::string& joint);

}  // namespace lacuna
