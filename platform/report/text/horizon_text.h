#pragma once

#include "fitting/comparison.h"

#include <string>
#include <vector>

namespace lacuna {

/// A trial's score of a channel; null: it has none.
const ChannelScore* score_of(const TrialComparison& trial, const std::string& channel);

/// Lengths over which any trial was predicted, s, as the comparison has them. `automatic`: with the one that follows
/// the uncertainty of starts, which differs from comparison to comparison.
std::vector<double> horizons_of(const Comparison& comparison, bool automatic = true);

/// Root of the mean square over the fit trials, or the held-out ones, of a channel's error over one horizon; not a
/// number where none was scored.
double restarted_error(const Comparison& comparison, const std::string& channel, double horizon, bool held_out);

}  // namespace lacuna
