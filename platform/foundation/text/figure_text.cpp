#include "foundation/text/figure_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMostShown = 0.99;
constexpr double kLastBits = 1e-9;     ///< 0.29 times 100 is less than 29
constexpr double kLeastRatio = 1e-4;   ///< remaining share of an error; more digits are not needed
constexpr double kSmallChange = 10.0;  ///< percent; below this one decimal is printed

int decimals_of(double ratio) {
  if (ratio < 0.01) return 2;
  return ratio < 0.1 || std::abs(100.0 * (ratio - 1.0)) < kSmallChange ? 1 : 0;
}

}  // namespace

std::string probability_text(double probability) {
  if (std::isnan(probability)) return "-";
  const double shown = std::min(kMostShown, std::floor(100.0 * probability + kLastBits) / 100.0);
  return shown < 0.01 ? "< 0.01" : fmt::format("{:.2f}", shown);
}

std::string error_change_text(double now, double then) {
  if (!std::isfinite(now) || !std::isfinite(then) || !(then > 0.0)) return "–";
  const double ratio = std::max(now / then, kLeastRatio);
  const std::string size = fmt::format("{:.{}f} %", std::abs(100.0 * (ratio - 1.0)), decimals_of(ratio));
  if (size == "0.0 %") return "0.0 %";
  return (ratio < 1.0 ? "−" : "+") + size;
}

}  // namespace lacuna
