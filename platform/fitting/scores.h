#pragma once

#include "fitting/comparison.h"

#include <vector>

namespace lacuna {

/// The figures of one channel over the rows from `first_scored` on that were measured. `floor` is filled in, what
/// needs other predictions (as written, numerical, start) is not.
ChannelScore score_channel(const TrialComparison& comparison, Eigen::Index channel, const FloorValue& floor);

/// RMS over the scored rows of a column; NaN if there are none.
double scored_rms(const TimeSeries::Samples& residuals, Eigen::Index channel, Eigen::Index first_scored);

/// Every channel over all fit trials, and over all held-out trials; without those that measured nothing to score.
std::vector<PooledScore> pool(const std::vector<TrialComparison>& trials, const std::vector<TrialFloor>& floors);

}  // namespace lacuna
