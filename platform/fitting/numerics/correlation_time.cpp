#include "fitting/numerics/correlation_time.h"

#include <algorithm>

namespace lacuna {
namespace {

double autocorrelation(std::span<const double> residuals, std::size_t lag, double power) {
  double product = 0.0;
  for (std::size_t i = lag; i < residuals.size(); ++i) product += residuals[i] * residuals[i - lag];
  return product / power;
}

}  // namespace

double correlation_samples(std::span<const double> residuals) {
  constexpr double kForgotten = 0.1;
  constexpr std::size_t kEach = 8;  // lags up to here one by one, then in steps of an eighth
  double power = 0.0;
  for (const double r : residuals) power += r * r;
  if (!(power > 0.0)) return 1.0;
  double sum = 1.0;
  double before = 1.0;
  std::size_t previous = 0;
  for (std::size_t lag = 1; lag < residuals.size() / 2; lag += std::max<std::size_t>(1, lag / kEach)) {
    const double correlation = autocorrelation(residuals, lag, power);
    if (correlation < kForgotten) break;
    const auto gap = static_cast<double>(lag - previous);
    sum +=
        2.0 * (correlation + 0.5 * (gap - 1.0) * (before + correlation));  // linear interpolation for the lags between
    before = correlation;
    previous = lag;
  }
  return std::max(sum, 1.0);
}

}  // namespace lacuna
