#pragma once

#include <lacuna/time_series.h>

#include <utility>

namespace lacuna {

/// A low-order polynomial through the samples of a channel near one sample, evaluated there.
struct LocalPolynomial {
  int points = 0;  ///< samples used; 0: nothing was measured nearby
  double value = 0.0;
  double slope = 0.0;  ///< 1/s; undefined with fewer than two points
  double value_deviation = 0.0;
  double slope_deviation = 0.0;
};

/// Factor, at least 1, by which the deviation of an average of these readings exceeds that of as many independent ones.
/// A reading that repeats the one before it (an encoder on one step) has the same error. n readings of r runs of equal
/// values count as r + 3: a line on one step for the whole window is bounded at its ends, so its start is as uncertain
/// as one reading, like the start of a line through four readings.
double repetition(const TimeSeries& series, Eigen::Index channel, std::pair<Eigen::Index, Eigen::Index> range);

/// Least squares through the measured samples of `range` (first, one past last) within `window` (s) of `sample`: half
/// before and half after, shifted to one side at the range's ends. The window grows until it holds one more point than
/// twice the unknowns, or all there are; the degree is reduced where there are too few. `noise`: standard deviation of
/// a sample; a larger scatter about the polynomial replaces it.
LocalPolynomial fit_local_polynomial(const TimeSeries& series, Eigen::Index channel,
                                     std::pair<Eigen::Index, Eigen::Index> range, Eigen::Index sample, int degree,
                                     double window, double noise);

}  // namespace lacuna
