#include "report/bound_text.h"

#include "foundation/unit.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

/// "effect.ID.PARAMETER" belongs to an effect; every other address to the robot.
bool is_of_effect(const FittedValue& value) { return value.address.starts_with("effect."); }

std::string meaning(const FittedValue& value) {
  const bool none_of_it = value.at_lower_bound && value.value == 0.0;
  if (none_of_it && is_of_effect(value)) return "the data do not want this effect";
  if (none_of_it) return "the data want none of it";
  const std::string more_or_less = value.at_lower_bound ? "less" : "more";
  if (is_of_effect(value))
    return fmt::format("the data want {} than the effect allows; another one may be meant", more_or_less);
  return fmt::format("the data want {}: the bound is too tight, or the value stands in for an effect that is missing",
                     more_or_less);
}

}  // namespace

std::string bound_text(const FitResult& fit) {
  std::string text;
  for (const FittedValue& value : fit.values)
    if (value.at_lower_bound || value.at_upper_bound)
      text += fmt::format("{} is at its {} bound, {}: {}\n", value.address, value.at_lower_bound ? "lower" : "upper",
                          format_quantity(value.value, value.unit), meaning(value));
  return text;
}

}  // namespace lacuna
