#include "fitting/correlation_time.h"

#include <algorithm>

namespace lacuna {

double correlation_samples(std::span<const double> residuals) {
  constexpr double kForgotten = 0.1;
  double power = 0.0;
  for (const double r : residuals) power += r * r;
  if (!(power > 0.0)) return 1.0;
  double sum = 1.0;
  for (std::size_t lag = 1; lag < residuals.size() / 2; ++lag) {
    double product = 0.0;
    for (std::size_t i = lag; i < residuals.size(); ++i) product += residuals[i] * residuals[i - lag];
    const double correlation = product / power;
    if (correlation < kForgotten) break;
    sum += 2.0 * correlation;
  }
  return std::max(sum, 1.0);
}

}  // namespace lacuna
