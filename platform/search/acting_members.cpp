#include "search/acting_members.h"

#include "candidates/wrong_value.h"
#include "foundation/statistics.h"
#include "criterion/value_errors.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

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

/// A size of an effect in a fitted set, in the coordinate of its value.
struct FittedSize {
  double way = 0.0;    ///< from the value at which the effect does nothing
  double error = 0.0;  ///< standard error; 0: the data do not tell the value

  bool is_told() const { return error > 0.0 && std::abs(way) > kWithin95 * error; }
  bool may_be_nothing() const { return way == 0.0 || (error > 0.0 && !is_told()); }
};

bool is_placed_for(const EffectEntry& entry, const Hypothesis& hypothesis) {
  return std::any_of(hypothesis.placed.begin(), hypothesis.placed.end(),
                     [&](const EffectEntry& one) { return member_name(one) == member_name(entry); });
}

/// Of a member, at all its places.
std::vector<FittedSize> fitted_sizes(const EffectEntry& member, const Eigen::VectorXd& errors, const FittedModel& set,
                                     const EffectLook& look) {
  std::vector<FittedSize> fitted;
  const Hypothesis* hypothesis = hypothesis_of(member, look);
  if (!hypothesis) return fitted;
  const std::set<std::string> sizes = sizes_of(member.effect, look);
  const std::vector<FreeValue>& free = set.model.definition.free;
  const ParameterSpace space(free);
  for (std::size_t i = 0; i < free.size(); ++i) {
    const std::string name = last_name(free[i].address);
    const bool is_own = std::any_of(set.model.placed.begin(), set.model.placed.end(), [&](const EffectEntry& entry) {
      return is_placed_for(entry, *hypothesis) && belongs_to(free[i], entry);
    });
    if (!is_own || (!sizes.empty() && !sizes.contains(name))) continue;
    const auto j = static_cast<Eigen::Index>(i);
    fitted.push_back({set.fit.point.values(j) - space.to_coordinate(j, neutral_of(*hypothesis, name)), errors(j)});
  }
  return fitted;
}

}  // namespace

bool acts(const EffectEntry& member, const FittedModel& set, const CellLayout& layout, const EffectLook& look) {
  const std::vector<FittedSize> sizes = fitted_sizes(member, standard_errors(set, layout), set, look);
  return std::any_of(sizes.begin(), sizes.end(), [](const FittedSize& size) { return size.is_told(); });
}

std::set<std::string> idle_members(const FittedModel& set, const CellLayout& layout, const EffectLook& look) {
  const Eigen::VectorXd errors = standard_errors(set, layout);
  std::set<std::string> idle;
  for (const EffectEntry& member : set.model.added) {
    const std::vector<FittedSize> sizes = fitted_sizes(member, errors, set, look);
    const auto may_be_nothing = [](const FittedSize& size) { return size.may_be_nothing(); };
    if (!sizes.empty() && std::all_of(sizes.begin(), sizes.end(), may_be_nothing)) idle.insert(member_name(member));
  }
  return idle;
}

}  // namespace lacuna
