#pragma once

#include <lacuna/trial.h>

#include "evaluation/model/model_definition.h"

#include <vector>

namespace lacuna {

/// Within one command interval, when commands act is a matter of recording (which side of a sample a command is held
/// on), no effect: it is fitted beside the model's values.
inline constexpr double kMostTiming = 1.0;  ///< command intervals, later or earlier

/// Command intervals by which commands may act earlier (negative) or later than recorded.
struct TimingRange {
  double earliest = -kMostTiming, latest = kMostTiming;
};

/// A model's free values, and how many command intervals later than recorded all commands act.
std::vector<FreeValue> with_timing(std::vector<FreeValue> free, const TimingRange& range = {});

/// s: of all trials the longest `command_interval`; 0 where nothing is commanded.
double longest_command_interval(const std::vector<Trial>& trials);

}  // namespace lacuna
