#include "report/text/bound_text.h"

#include "fitting/stage_drift.h"
#include "foundation/address.h"
#include "foundation/unit.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

/// Whether shorter segments told value `i` differently.
bool moved_to_its_bound(const FitResult& fit, std::size_t i) {
  if (fit.stages.size() < 2) return false;
  return moved({fit.stages[fit.stages.size() - 2].values[i]}, {fit.values[i].value});
}

std::string meaning(const FitResult& fit, std::size_t i) {
  const FittedValue& value = fit.values[i];
  const bool none_of_it = value.at_lower_bound && value.value == 0.0;
  if (none_of_it && moved_to_its_bound(fit, i))
    return "whole trials want none of it, though shorter segments do: something else is missing, too";
  if (none_of_it && is_of_effect(value.address)) return "the data do not want this effect";
  if (none_of_it) return "the data want none of it";
  const std::string more_or_less = value.at_lower_bound ? "less" : "more";
  if (is_of_effect(value.address))
    return fmt::format("the data want {} than the effect allows; another one may be meant", more_or_less);
  return fmt::format("the data want {}: the bound is too tight, or the value stands in for an effect that is missing",
                     more_or_less);
}

}  // namespace

std::string bound_text(const FitResult& fit) {
  std::string text;
  for (std::size_t i = 0; i < fit.values.size(); ++i) {
    const FittedValue& value = fit.values[i];
    if (value.at_lower_bound || value.at_upper_bound)
      text += fmt::format("{} is at its {} bound, {}: {}\n", value.address, value.at_lower_bound ? "lower" : "upper",
                          format_quantity(value.value, value.unit), meaning(fit, i));
  }
  return text;
}

}  // namespace lacuna
