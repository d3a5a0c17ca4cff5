#include "search/fit_starts.h"

namespace lacuna {
namespace {

constexpr double kSlightly = 0.02;  ///< of a size's distance from its neutral value

}  // namespace

NamedValues slightly(const NamedValues& with, const NamedValues& without, const EffectLook& look) {
  NamedValues start = without;
  for (const Hypothesis& hypothesis : look.hypotheses) {
    const std::vector<std::string> names = hypothesis.own_names();
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto found = with.find(names[i]);
      if (found == with.end() || start.contains(names[i])) continue;
      const double neutral = hypothesis.neutral[i], value = found->second;
      const bool is_linear = hypothesis.definition.free[hypothesis.own[i]].scale == Scale::linear;
      start[names[i]] = is_linear ? neutral + kSlightly * (value - neutral) : value;
    }
  }
  return start;
}

NamedValues both_values(const NamedValues& other, const NamedValues& one) {
  NamedValues start = one;
  start.insert(other.begin(), other.end());
  return start;
}

}  // namespace lacuna
