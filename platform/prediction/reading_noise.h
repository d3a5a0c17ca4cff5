#pragma once

#include "fitting/floor/noise_floor.h"
#include "prediction/smoothed_starts.h"

#include <vector>

namespace lacuna {

/// Standard deviations of readings: as declared, else as found by the smoother, else from `noise`.
std::vector<ChannelNoise> noise_of_readings(const SmoothedStarts& starts, const std::vector<Trial>& trials,
                                            std::vector<ChannelNoise> noise);

/// Of one channel the figure for a comparison: that of the smoothed readings, which a diagnosis takes, unless it is
/// more than twice the other one, from rest or differences; then the smoother took fast motion for noise, and the
/// origin says which figure the diagnosis takes.
ChannelNoise agreed(const ChannelNoise& other, const ChannelNoise& smoothed);

/// The noise of all trials of a predictor for a comparison, by `agreed`. From `sensor_noise` where it is declared and
/// where there are too few readings to smooth.
std::vector<ChannelNoise> noise_of_readings(const RobotSpec& robot, const TrialPredictor& predictor);

}  // namespace lacuna
