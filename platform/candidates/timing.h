#pragma once

#include <lacuna/trial.h>

#include "evaluation/model/model_definition.h"

#include <vector>

namespace lacuna {

/// Within one command interval, the time at which commands act is a timestamp offset (which side of a sample a command
/// is held on), not an effect: it is fitted beside the model's values.
inline constexpr double kMostTiming = 1.0;  ///< command intervals, later or earlier

/// Command intervals by which commands may act earlier (negative) or later than recorded.
struct TimingRange {
  double earliest = -kMostTiming, latest = kMostTiming;
};

/// A model's free values, and the delay of all commands against the recording in command intervals.
std::vector<FreeValue> with_timing(std::vector<FreeValue> free, const TimingRange& range = {});

/// s: the longest `command_interval` of all trials; 0 where there are no commands.
double longest_command_interval(const std::vector<Trial>& trials);

}  // namespace lacuna
