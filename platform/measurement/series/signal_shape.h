#pragma once

#include <lacuna/time_series.h>

#include <cstddef>

namespace lacuna {

/// The shape of a channel, without knowledge of its meaning. NaNs do not count.
struct SignalShape {
  std::size_t count = 0;  ///< of values
  double lowest = 0.0;
  double highest = 0.0;
  /// Samples in runs of at least five at the limit that the signal reached at full speed, as in a saturated converter;
  /// 0 where it reverses smoothly, has only few values, or stays as long in between.
  std::size_t clipped = 0;
  std::size_t clipped_runs = 0;
  bool clipped_high = false;
};

SignalShape shape_of(const TimeSeries& series, Eigen::Index channel);

/// Agreement of the integral of a velocity channel with a position channel, over some fifty parts.
struct SlopeMatch {
  double ratio = 0.0;        ///< velocity over slope of the position: 1 where they belong together
  double correlation = 0.0;  ///< 0 where there is too little motion
};

SlopeMatch match_slope(const TimeSeries& series, Eigen::Index position, Eigen::Index velocity);

}  // namespace lacuna
