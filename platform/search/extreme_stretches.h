#pragma once

#include "prediction/prediction_ladder.h"

#include <string>
#include <vector>

namespace lacuna {

/// Of "joint.hinge", "actuator.motor" or "sensor.angle", or of a value there, the joint; otherwise empty.
std::string joint_at(const RobotSpec& robot, const std::string& where);

/// By which the sizes of an effect are found: few stretches of the middle length, and the extremes of its joint.
PredictionLadder for_sizes(const PredictionLadder& ladder, const RobotSpec& robot, const std::vector<Trial>& trials,
                           const std::string& joint);

}  // namespace lacuna
