#include "search/set_order.h"

#include <algorithm>
#include <iterator>

namespace lacuna {
namespace {

constexpr double kUntold = 0.1;        ///< of what a value must gain: one that the data do not tell
constexpr double kBlocksAValue = 3.0;  ///< of time, that there are at least for each value
constexpr double kAlikeCost = 0.01;    ///< nats

}  // namespace

double SetOrder::largest_gain() const {
  double gain = 0.0;
  for (const auto& [name, set] : sets_.all())
    if (set.fit.errors.valid) gain = std::max(gain, base().cross.cost - set.cross.cost);
  return gain;
}

double SetOrder::with_size(const FittedSet& set, double gain) const {
  const auto effects = static_cast<double>(set.model.added.size());
  const auto more = static_cast<double>(set.model.values.size() - base().model.values.size());
  const double values = std::max(effects, more);
  const double told = std::clamp(static_cast<double>(set.cross.told - base().cross.told), effects, values);
  return set.cross.cost + kRelevant * gain * (told + kUntold * (values - told));
}

bool SetOrder::is_told(const FittedSet& set) const {
  const int more = set.cross.told - base().cross.told;
  return kBlocksAValue * static_cast<double>(more) <= static_cast<double>(set.cross.by_block.size());
}

std::vector<std::string> SetOrder::best_of(std::size_t size, std::size_t most) const {
  const double gain = largest_gain();
  std::vector<std::string> names;
  for (const auto& [name, set] : sets_.all())
    if (set.model.added.size() == size && set.fit.errors.valid && is_told(set)) names.push_back(name);
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return with_size(*sets_.find(a), gain) < with_size(*sets_.find(b), gain);
  });
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
  if (!set.fit.errors.valid) return set.rough.errors.cost - answer.rough.errors.cost < kAlikeCost;
  const CostDifference over = difference(answer, set);
  return over.nats < std::max(kAlikeCost, over.error);
}

}  // namespace lacuna
