#include "report/figures/spread.h"

#include "foundation/statistics.h"

#include <cmath>
#include <limits>

namespace lacuna {

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  double sum = 0.0, squares = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++spread.count;
    sum += value;
  }
  const auto count = static_cast<double>(spread.count);
  spread.mean = spread.count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
  for (const double value : values)
    if (std::isfinite(value)) squares += (value - spread.mean) * (value - spread.mean);
  spread.half_width = std::numeric_limits<double>::infinity();
  if (spread.count < 2) return spread;
  spread.deviation = std::sqrt(squares / (count - 1.0));
  const double t = within_95_of_students_t(count - 1.0);
  spread.half_width = t * spread.deviation / std::sqrt(count);
  return spread;
}

}  // namespace lacuna
