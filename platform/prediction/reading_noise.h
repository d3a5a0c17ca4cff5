#pragma once

#include "fitting/floor/noise_floor.h"
#include "prediction/smoothed_starts.h"

#include <vector>

namespace lacuna {

/// Standard deviations of readings: as declared, else as found by the smoother, else from `noise`.
std::vector<ChannelNoise> noise_of_readings(const SmoothedStarts& starts, const std::vector<Trial>& trials,
                                            std::vector<ChannelNoise> noise);

/// The same of all trials of a predictor, so that a comparison and a diagnosis of them have one noise. As
/// `sensor_noise` has it where readings are too few to be smoothed.
std::vector<ChannelNoise> noise_of_readings(const RobotSpec& robot, const TrialPredictor& predictor);

}  // namespace lacuna
