#include "fitting/numerics/scored_rms.h"

#include <cmath>
#include <limits>

namespace lacuna {

double scored_rms(const TimeSeries::Samples& residuals, Eigen::Index channel, Eigen::Index first_scored) {
  double squares = 0.0, count = 0.0;
  for (Eigen::Index row = first_scored; row < residuals.rows(); ++row) {
    const double residual = residuals(row, channel);
    if (!std::isfinite(residual)) continue;
    squares += residual * residual;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace lacuna
