#pragma once

#include <lacuna/time_series.h>

#include <utility>

namespace lacuna {

/// A low polynomial through the samples of a channel near one sample: what it says there.
struct LocalPolynomial {
  int points = 0;  ///< samples used; 0: nothing was measured nearby
  double value = 0.0;
  double slope = 0.0;  ///< 1/s; of no meaning with fewer than two points
  double value_deviation = 0.0;
  double slope_deviation = 0.0;
};

/// By how much the deviation of an average of these readings is larger than that of as many independent ones, at
/// least 1. A reading that repeats the one before it (an encoder that stays on its step) carries the same error again.
/// n readings of r runs of equal values count as r + 3: a line that stays on one step for the whole window is bounded
/// at its ends, which makes its start as uncertain as one reading, and four readings' line has such a start.
double repetition(const TimeSeries& series, Eigen::Index channel, std::pair<Eigen::Index, Eigen::Index> range);

/// Least squares through the measured samples of `range` (first, one past last) whose times lie within
/// `window` (s) of `sample`: half before and half after, shifted to one side at the range's ends. The
/// window grows until it holds a point more than twice the unknowns, or all there are; the degree falls where
/// there are too few. `noise`: standard deviation of a sample; a larger scatter about the polynomial replaces it.
LocalPolynomial fit_local_polynomial(const TimeSeries& series, Eigen::Index channel,
                                     std::pair<Eigen::Index, Eigen::Index> range, Eigen::Index sample, int degree,
                                     double window, double noise);

}  // namespace lacuna
