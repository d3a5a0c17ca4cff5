#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/refit/refit.h"

#include <vector>

namespace lacuna {

/// Within one command interval, when commands act is a matter of recording (which side of a sample a command is held
/// on), no effect: it is fitted beside the model's values. That it is anywhere in between is known beforehand, and
/// counts as much as the variance of an even distribution tells.
inline constexpr double kMostTiming = 1.0;  ///< command intervals, later or earlier
inline constexpr double kTimingVariance = kMostTiming * kMostTiming / 3.0;

/// Command intervals by which commands may act earlier (negative) or later than recorded.
struct TimingRange {
  double earliest = -kMostTiming, latest = kMostTiming;
};

/// A model's free values, and how many command intervals later than recorded all commands act.
std::vector<FreeValue> with_timing(std::vector<FreeValue> free, const TimingRange& range = {});

/// s: of all trials the longest `command_interval`; 0 where nothing is commanded.
double longest_command_interval(const std::vector<Trial>& trials);

/// Whether data tell the timing of a fit beside its values and starts, to a third of an interval: else a model that
/// holds a delay, or whose start makes up for one, would have two values that do the same.
bool tells_timing(const Refit& fit);

/// How many values explain what a fit does: those of the model, and the timing where the data tell it.
double freedom(const Refit& fit);

/// Takes the residuals of a base's linear segments where commands act as late as its timing says, and takes down how
/// they change with that (not at all where neither side can be simulated); the derivatives by values and starts stay
/// those of commands as recorded. Throws `Error` where the model cannot be simulated so.
void linearise_timing(const Contender& contender, const RowBins& bins, int threads, BaseSolution& base);

/// A base's linear segments with its timing beside the values, unless that is `held` at a bound.
std::vector<LinearSegment> beside_timing(const BaseSolution& base, bool held);

}  // namespace lacuna
