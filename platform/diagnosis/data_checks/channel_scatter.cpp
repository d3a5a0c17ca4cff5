#include "diagnosis/data_checks/channel_scatter.h"

#include <cmath>

namespace lacuna {

double scatter_of(const TimeSeries& series, Eigen::Index channel) {
  constexpr double kPower = 6.0;  // 1² + 2² + 1²
  double squares = 0.0, count = 0.0;
  for (Eigen::Index i = 2; i < series.samples.rows(); ++i) {
    const double second =
        series.samples(i, channel) - 2.0 * series.samples(i - 1, channel) + series.samples(i - 2, channel);
    if (!std::isfinite(second)) continue;
    squares += second * second;
    count += 1.0;
  }
  return count == 0.0 ? 0.0 : std::sqrt(squares / (kPower * count));
}

}  // namespace lacuna
