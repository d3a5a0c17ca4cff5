#pragma once

#include <lacuna/time_series.h>

#include <Eigen/Core>

namespace lacuna {

/// Standard deviation of white noise that would give the second differences of a channel; includes real motion within
/// three samples. 0 with fewer than three readings without a gap.
double scatter_of(const TimeSeries& series, Eigen::Index channel);

}  // namespace lacuna
