#include "search/set_order.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace lacuna {
namespace {

constexpr double kUntold = 0.1;        ///< of what a value must gain: one that the data do not tell
constexpr double kOnTheWay = 0.5;      ///< of what a value must gain: what simpler sets come first by, on few segments
constexpr double kBlocksAValue = 3.0;  ///< of time, that there are at least for each value
constexpr double kAlikeCost = 0.01;    ///< nats

constexpr double kSameCost = 1e-3;  ///< nats

/// Of effects that do the same, one at a joint comes first: far less than any difference that matters.
double far_from_joints(const FittedSet& set) {
  double elsewhere = 0.0;
  for (const EffectEntry& entry : set.model.added)
    if (entry.where.empty() || !entry.where.front().starts_with("joint.")) elsewhere += 1.0;
  return 0.2 * kSameCost * elsewhere;
}

}  // namespace

bool SetOrder::is_fitted(const FittedSet& set) const {
  return segments_ == Segments::few ? set.few.errors.valid : set.all.valid() && is_told(set);
}

double SetOrder::cost(const FittedSet& set) const {
  return segments_ == Segments::few ? set.few.errors.cost : set.all.cross.cost;
}

double SetOrder::largest_gain() const {
  double gain = 0.0;
  for (const auto& [name, set] : sets_)
    if (is_fitted(set)) gain = std::max(gain, cost(base()) - cost(set));
  return gain;
}

double SetOrder::with_size(const FittedSet& set, double gain) const {
  const auto effects = static_cast<double>(set.model.added.size());
  const auto more = static_cast<double>(set.model.values.size() - base().model.values.size());
  const double values = std::max(effects, more), least = cost(set) + far_from_joints(set);
  if (segments_ == Segments::few) return least + kOnTheWay * kRelevant * gain * values;
  const int more_told = set.all.cross.told - base().all.cross.told;
  const double told = std::clamp(static_cast<double>(more_told), effects, values);
  return least + kRelevant * gain * (told + kUntold * (values - told));
}

bool SetOrder::is_told(const FittedSet& set) const {
  const int more = set.all.cross.told - base().all.cross.told;
  return kBlocksAValue * static_cast<double>(more) <= static_cast<double>(set.all.cross.by_block.size());
}

std::vector<std::string> SetOrder::ordered() const {
  const double gain = largest_gain();
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, set] : sets_)
    if (is_fitted(set)) order.emplace_back(with_size(set, gain), name);
  std::sort(order.begin(), order.end());
  std::vector<std::string> names;
  double before = -std::numeric_limits<double>::infinity();
  for (const auto& [cost, name] : order) {
    if (cost - before >= kSameCost) names.push_back(name);
    before = cost;
  }
  return names;
}

std::vector<std::string> SetOrder::best_among(const std::vector<std::string>& names, std::size_t most) const {
  std::vector<std::string> best;
  for (const std::string& name : ordered())
    if (best.size() < most && std::find(names.begin(), names.end(), name) != names.end()) best.push_back(name);
  return best;
}

std::vector<std::string> SetOrder::best_of(std::size_t size, std::size_t most) const {
  std::vector<std::string> names = ordered();
  std::erase_if(names, [&](const std::string& name) { return sets_.at(name).model.added.size() != size; });
  if (names.size() > most) names.resize(most);
  return names;
}

std::set<std::string> effects_of(const FittedSet& set) {
  std::set<std::string> names;
  for (const EffectEntry& entry : set.model.added) names.insert(name_of_set({entry}));
  return names;
}

bool does_the_same(const FittedSet& set, const FittedSet& answer) {
  const std::set<std::string> own = effects_of(answer), other = effects_of(set);
  std::vector<std::string> both;
  std::set_intersection(own.begin(), own.end(), other.begin(), other.end(), std::back_inserter(both));
  if (own.empty() || other.size() != own.size() || both.size() + 1 != own.size()) return false;
  if (!set.all.valid()) return set.few.errors.valid && set.few.errors.cost - answer.few.errors.cost < kAlikeCost;
  const CostDifference over = difference(answer.all, set.all);
  return over.nats < std::max(kAlikeCost, over.error);
}

}  // namespace lacuna
