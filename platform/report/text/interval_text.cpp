#include "report/text/interval_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kFewestDigits = 3;
constexpr int kMostDigits = 7;

}  // namespace

int interval_digits(double value, double width) {
  if (!(width > 0.0) || !std::isfinite(width) || value == 0.0) return kFewestDigits;
  const double needed = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(width)) + 2.0;
  return std::clamp(static_cast<int>(needed), kFewestDigits, kMostDigits);
}

IntervalText interval_text(const FittedValue& value) {
  const int digits = interval_digits(value.value, value.upper_95 - value.lower_95);
  const auto number = [&](double x) { return fmt::format("{:#.{}g}", x, digits); };
  if (value.at_lower_bound) return {number(value.value), "at its lower bound"};
  if (value.at_upper_bound) return {number(value.value), "at its upper bound"};
  if (std::isnan(value.lower_95) && std::isnan(value.upper_95)) return {number(value.value), ""};
  if (!value.identified) return {number(value.value), "not determined"};
  return {number(value.value), fmt::format("[{}, {}]", number(value.lower_95), number(value.upper_95))};
}

}  // namespace lacuna
