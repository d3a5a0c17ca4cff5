#include "report/text/bound_text.h"

#include "fitting/stage_drift.h"
#include "foundation/address.h"
#include "foundation/unit.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

/// Whether shorter segments gave another value `i`.
bool moved_to_its_bound(const FitResult& fit, std::size_t i) {
  if (fit.stages.size() < 2) return false;
  return moved({fit.stages[fit.stages.size() - 2].values[i]}, {fit.values[i].value});
}

std::string meaning(const FitResult& fit, std::size_t i) {
  const FittedValue& value = fit.values[i];
  const bool none_of_it = value.at_lower_bound && value.value == 0.0;
  if (none_of_it && moved_to_its_bound(fit, i))
    return "whole trials give this value, but shorter segments do not, so something else is missing too";
  if (none_of_it && is_of_effect(value.address)) return "this effect does not improve the model";
  if (none_of_it) return "another value does not improve the model";
  const std::string more_or_less = value.at_lower_bound ? "smaller" : "larger";
  if (is_of_effect(value.address))
    return fmt::format("a {} value than the effect allows would fit better; the missing effect may be another one",
                       more_or_less);
  return fmt::format("a {} value would fit better: the bound is too tight, or the value has absorbed a missing effect",
                     more_or_less);
}

}  // namespace

std::string bound_text(const FitResult& fit) {
  std::string text;
  for (std::size_t i = 0; i < fit.values.size(); ++i) {
    const FittedValue& value = fit.values[i];
    if (value.at_lower_bound || value.at_upper_bound)
      text += fmt::format("{}: the fit stopped at the {} bound, {}: {}\n", value.address,
                          value.at_lower_bound ? "lower" : "upper", format_quantity(value.value, value.unit),
                          meaning(fit, i));
  }
  return text;
}

}  // namespace lacuna
