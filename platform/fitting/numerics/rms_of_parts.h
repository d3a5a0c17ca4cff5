#pragma once

#include <lacuna/time_series.h>

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// Root mean square over all rows of all parts; 0 without any.
double rms_of_parts(const std::vector<Eigen::VectorXd>& parts);

/// RMS over the scored rows of a column; NaN if there are none.
double scored_rms(const TimeSeries::Samples& residuals, Eigen::Index channel, Eigen::Index first_scored);

}  // namespace lacuna
