#include "search/fit_starts.h"

namespace lacuna {
namespace {

constexpr double kSlightly = 0.02;  ///< of a size's distance from its neutral value

}  // namespace

NamedValues slightly(const NamedValues& with, const NamedValues& without, const EffectLook& look) {
  NamedValues start = without;
  for (const Hypothesis& hypothesis : look.hypotheses)
    for (std::size_t i = 0; i < hypothesis.own.size(); ++i) {
      const FreeValue& free = hypothesis.definition.free[hypothesis.own[i]];
      const std::string name = member_name(hypothesis.entry) + free.address.substr(free.address.rfind('.'));
      const auto found = with.find(name);
      if (found == with.end() || start.contains(name)) continue;
      const double neutral = hypothesis.neutral[i], value = found->second;
      start[name] = free.scale == Scale::linear ? neutral + kSlightly * (value - neutral) : value;
    }
  return start;
}

NamedValues both_values(const NamedValues& other, const NamedValues& one) {
  NamedValues start = one;
  start.insert(other.begin(), other.end());
  return start;
}

}  // namespace lacuna
