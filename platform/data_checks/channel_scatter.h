#pragma once

#include <lacuna/time_series.h>

#include <Eigen/Core>

namespace lacuna {

/// Standard deviation of the white noise that the second differences of a channel would be; includes what really moves
/// within three samples. 0 with fewer than three readings without a
/// pause.
double scatter_of(const TimeSeries& series, Eigen::Index channel);

}  // namespace lacuna
