#include "report/text/times_floor_text.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {

std::string times_floor_text(double factor) {
  if (!std::isfinite(factor)) return "-";
  if (factor > 1000.0) return ">1000";
  return fmt::format("{:.{}f}", factor, factor < 99.95 ? 1 : 0);
}

}  // namespace lacuna
