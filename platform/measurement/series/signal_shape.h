#pragma once

#include <lacuna/time_series.h>

#include <cstddef>

namespace lacuna {

/// What a channel looks like, without knowing what it is. NaNs do not count.
struct SignalShape {
  std::size_t count = 0;  ///< of values
  double lowest = 0.0;
  double highest = 0.0;
  /// Samples in runs of at least five at the limit that the signal reached in full motion, as where a
  /// converter saturates; 0 where it turns round smoothly, knows only few values, or stays as long in between.
  std::size_t clipped = 0;
  std::size_t clipped_runs = 0;
  bool clipped_high = false;
};

SignalShape shape_of(const TimeSeries& series, Eigen::Index channel);

/// How the integral of a velocity channel goes with a position channel, over some fifty stretches.
struct SlopeMatch {
  double ratio = 0.0;        ///< velocity by slope of the position: 1 where they belong together
  double correlation = 0.0;  ///< 0 where there is too little motion to tell
};

SlopeMatch match_slope(const TimeSeries& series, Eigen::Index position, Eigen::Index velocity);

}  // namespace lacuna
