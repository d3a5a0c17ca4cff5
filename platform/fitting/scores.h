#pragma once

#include "fitting/comparison.h"

#include <vector>

namespace lacuna {

/// The figures of one channel over the rows from `first_scored` on that were measured. `floor` is filled in, what
/// needs other predictions (as written, numerical, start) is not.
ChannelScore score_channel(const TrialComparison& comparison, Eigen::Index channel, const FloorValue& floor);

/// Every channel over all fit trials, and over all held-out trials; without those that measured nothing to score.
std::vector<PooledScore> pool(const std::vector<TrialComparison>& trials, const std::vector<TrialFloor>& floors);

}  // namespace lacuna
