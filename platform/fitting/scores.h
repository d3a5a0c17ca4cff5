#pragma once

#include "fitting/comparison.h"

#include <vector>

namespace lacuna {

/// The figures of one channel over the measured rows from `first_scored` on. `floor` is filled in; figures that need
/// other predictions (as written, numerical, start) are not.
ChannelScore score_channel(const TrialComparison& comparison, Eigen::Index channel, const FloorValue& floor);

/// Every channel over all fit trials, and over all held-out trials; without those that measured nothing to score.
std::vector<PooledScore> pool(const std::vector<TrialComparison>& trials, const std::vector<TrialFloor>& floors);

}  // namespace lacuna
