#include "answer/fitted_values.h"

#include "foundation/statistics.h"
#include "candidates/wrong_value.h"
#include "criterion/value_errors.h"
#include "foundation/processes/guarded_call.h"

#include <lacuna/physical_effect.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

/// Standard deviation of a value that may lie anywhere between its bounds, as a share of their distance.
constexpr double kSaysSomething = 0.9;
constexpr double kAtBound = 1e-9;          ///< of a range
constexpr double kToldTiming = 1.0 / 3.0;  ///< command intervals

std::vector<HeldParameter> held_values(const ModelStructure& structure, const EffectEntry& entry) {
  std::vector<HeldParameter> held;
  for (const PlacedEffect& placed : structure.effects) {
    if (placed.id != entry.id || entry.fixed.empty()) continue;
    const EffectDescription description =
        guarded_call(origin_of(placed), "describe", [&] { return placed.effect->describe(); });
    for (std::size_t i = 0; i < description.parameters.size(); ++i)
      if (const ParameterDeclaration& one = description.parameters[i];
          std::count(entry.fixed.begin(), entry.fixed.end(), one.name) > 0)
        held.push_back({one.name, one.unit, placed.values[i]});
  }
  return held;
}

/// The value of the robot file, for a fixed value that may be wrong.
double stated_value(const std::vector<FreeValue>& free, const EffectEntry& entry) {
  return std::find_if(free.begin(), free.end(), [&](const FreeValue& one) { return belongs_to(one, entry); })->start;
}

std::vector<FreeValue> all_values(const SearchResult& found, const FittedModel& set) {
  const std::vector<FreeValue>& free = set.model.definition.free;
  return found.data->timing() ? with_timing(free, kCommandsMayAct) : free;
}

}  // namespace

FittedValues::FittedValues(const SearchResult& found, const FittedModel& set)
    : set_(set), timing_(found.data->timing()), space_(all_values(found, set)) {
  const LinearCost least = least_cost(found.layout, set.fit.products, set.fit.bounds);
  const ValueErrors errors = value_errors(found.layout, set.fit.products, least);
  covariance_ = errors.covariance;
  for (Eigen::Index j = 0; j < space_.size(); ++j) {
    const double untold = (space_.upper()(j) - space_.lower()(j)) / std::sqrt(12.0);  // anywhere within its bounds
    if (!is_at_bound(j) && errors.is_told[static_cast<std::size_t>(j)] &&
        std::sqrt(covariance_(j, j)) < kSaysSomething * untold)
      continue;
    covariance_.row(j).setZero();
    covariance_.col(j).setZero();
  }
}

bool FittedValues::is_at_bound(Eigen::Index j) const {
  const double at = set_.fit.point.values(j), lower = space_.lower()(j), upper = space_.upper()(j);
  return at <= lower + kAtBound * (upper - lower) || at >= upper - kAtBound * (upper - lower);
}

FoundParameter FittedValues::parameter(std::size_t value, const std::string& name) const {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  const auto j = static_cast<Eigen::Index>(value);
  const double at = set_.fit.point.values(j), deviation = std::sqrt(covariance_(j, j));
  FoundParameter found{name, set_.model.definition.free[value].unit, space_.to_value(j, at), kNothing, kNothing};
  found.at_bound = is_at_bound(j);
  if (deviation > 0.0) {
    found.lower_95 = space_.to_value(j, std::max(space_.lower()(j), at - kWithin95 * deviation));
    found.upper_95 = space_.to_value(j, std::min(space_.upper()(j), at + kWithin95 * deviation));
  }
  return found;
}

std::vector<FoundEffect> FittedValues::effects() const {
  std::vector<FoundEffect> effects;
  const std::vector<FreeValue>& free = set_.model.definition.free;
  for (const EffectEntry& entry : set_.model.added) {
    FoundEffect effect{entry.effect, entry.where.empty() ? "world" : entry.where.front(), {}};
    for (std::size_t i = 0; i < free.size(); ++i)
      if (belongs_to(free[i], entry)) effect.parameters.push_back(parameter(i, last_name(free[i].address)));
    if (is_wrong_value(entry)) effect.parameters.front().stated = stated_value(free, entry);
    effect.held = held_values(set_.model.definition.structure, entry);
    effects.push_back(std::move(effect));
  }
  return effects;
}

std::vector<FoundParameter> FittedValues::own() const {
  std::vector<FoundParameter> values;
  const std::vector<EffectEntry>& added = set_.model.added;
  for (std::size_t i = 0; i < set_.model.definition.free.size(); ++i) {
    const FreeValue& free = set_.model.definition.free[i];
    if (std::none_of(added.begin(), added.end(), [&](const EffectEntry& entry) { return belongs_to(free, entry); }))
      values.push_back(parameter(i, free.address));
  }
  return values;
}

std::vector<double> FittedValues::values() const {
  std::vector<double> all = space_.to_values(set_.fit.point.values);
  all.resize(set_.model.definition.free.size());
  return all;
}

std::optional<double> FittedValues::timing() const {
  if (!timing_) return std::nullopt;
  return set_.fit.point.values(set_.fit.point.values.size() - 1);
}

bool FittedValues::timing_is_told() const {
  if (!timing_) return false;
  const Eigen::Index last = covariance_.rows() - 1;
  return covariance_(last, last) > 0.0 && std::sqrt(covariance_(last, last)) < kToldTiming;
}

}  // namespace lacuna
