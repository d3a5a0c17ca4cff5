#pragma once

#include <lacuna/time_series.h>

#include <Eigen/Core>

namespace lacuna {

/// RMS over the scored rows of a column; NaN if there are none.
double scored_rms(const TimeSeries::Samples& residuals, Eigen::Index channel, Eigen::Index first_scored);

}  // namespace lacuna
