#include "answer/bound_findings.h"

#include "foundation/address.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kOnBound = 1e-9;  // of the distance between the bounds

struct Bound {
  const char* name;
  double at;
  double end_of_interval;
};

std::string sentence(const FreeValue& free, const FoundParameter& value, const Bound& bound) {
  const double near = kOnBound * (free.upper - free.lower);
  const bool is_lower = bound.at == free.lower;
  if ((is_lower && bound.at == 0.0) || !std::isfinite(bound.at)) return "";
  const std::string which =
      fmt::format("{} bound{}, {}", bound.name, is_of_effect(free.address) ? "" : " in [model.free]",
                  format_quantity(bound.at, free.unit));
  if (value.at_bound && std::abs(value.value - bound.at) <= near)
    return fmt::format(
        "{} is at its {}: a {} value would fit better: the bound is too tight, or the value has absorbed a missing "
        "effect",
        value.name, which, is_lower ? "smaller" : "larger");
  if (!(std::abs(bound.end_of_interval - bound.at) <= near)) return "";
  return fmt::format("{}: its {}, cuts its 95 % interval short; widen it if the value may be {}", value.name, which,
                     is_lower ? "smaller" : "larger");
}

}  // namespace

std::vector<std::string> bound_findings(const std::vector<FreeValue>& free, const std::vector<FoundParameter>& values) {
  std::vector<std::string> findings;
  for (const FoundParameter& value : values) {
    const auto one =
        std::find_if(free.begin(), free.end(), [&](const FreeValue& f) { return f.address == value.name; });
    if (one == free.end()) continue;
    for (const Bound& bound : {Bound{"lower", one->lower, value.lower_95}, Bound{"upper", one->upper, value.upper_95}})
      if (std::string text = sentence(*one, value, bound); !text.empty()) findings.push_back(std::move(text));
  }
  return findings;
}

}  // namespace lacuna
