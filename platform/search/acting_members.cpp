#include "search/acting_members.h"

#include "candidates/wrong_value.h"
#include "foundation/statistics.h"
#include "criterion/value_errors.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace lacuna {
namespace {

const Hypothesis* hypothesis_of(const EffectEntry& member, const EffectLook& look) {
  const auto found = std::find_if(look.hypotheses.begin(), look.hypotheses.end(),
                                  [&](const Hypothesis& one) { return member_name(one.entry) == member_name(member); });
  return found == look.hypotheses.end() ? nullptr : &*found;
}

/// Names of an effect's sizes; empty where no probe of it tells.
std::set<std::string> sizes_of(const std::string& effect, const EffectLook& look) {
  std::set<std::string> names;
  if (!look.responses) return names;
  for (std::size_t h = 0; h < look.responses->size(); ++h) {
    const Hypothesis& one = look.hypotheses[h];
    if (one.entry.effect != effect) continue;
    for (const ProbeResponse& response : look.responses->at(h))
      if (response.probe.sized) names.insert(last_name(one.definition.free[one.own[*response.probe.sized]].address));
  }
  return names;
}

/// The value at which the effect does nothing.
double neutral_of(const Hypothesis& hypothesis, const std::string& parameter) {
  for (std::size_t k = 0; k < hypothesis.own.size(); ++k)
    if (last_name(hypothesis.definition.free[hypothesis.own[k]].address) == parameter) return hypothesis.neutral[k];
  return 0.0;
}

Eigen::VectorXd standard_errors(const FittedModel& set, const CellLayout& layout) {
  return value_errors(layout, set.fit.products, least_cost(layout, set.fit.products, set.fit.bounds)).standard();
}

bool acts_within(const Eigen::VectorXd& errors, const EffectEntry& member, const FittedModel& set,
                 const EffectLook& look) {
  const Hypothesis* hypothesis = hypothesis_of(member, look);
  if (!hypothesis) return true;
  const std::set<std::string> sizes = sizes_of(member.effect, look);
  const std::vector<FreeValue>& free = set.model.definition.free;
  const ParameterSpace space(free);
  const std::vector<EffectEntry>& placed = set.model.placed;
  const auto is_own = [&](const FreeValue& value) {
    return std::any_of(placed.begin(), placed.end(), [&](const EffectEntry& entry) {
      const bool is_part = std::any_of(hypothesis->placed.begin(), hypothesis->placed.end(),
                                       [&](const auto& one) { return member_name(one) == member_name(entry); });
      return is_part && belongs_to(value, entry);
    });
  };
  for (std::size_t i = 0; i < free.size(); ++i) {
    const std::string name = last_name(free[i].address);
    if (!is_own(free[i]) || (!sizes.empty() && !sizes.contains(name))) continue;
    const auto j = static_cast<Eigen::Index>(i);
    const double way = set.fit.point.values(j) - space.to_coordinate(j, neutral_of(*hypothesis, name));
    if (errors(j) > 0.0 && std::abs(way) > kWithin95 * errors(j)) return true;
  }
  return false;
}

}  // namespace

bool acts(const EffectEntry& member, const FittedModel& set, const CellLayout& layout, const EffectLook& look) {
  return acts_within(standard_errors(set, layout), member, set, look);
}

std::set<std::string> idle_members(const FittedModel& set, const CellLayout& layout, const EffectLook& look) {
  const Eigen::VectorXd errors = standard_errors(set, layout);
  std::set<std::string> idle;
  for (const EffectEntry& member : set.model.added)
    if (!acts_within(errors, member, set, look)) idle.insert(member_name(member));
  return idle;
}

}  // namespace lacuna
