#include "search/fitted_sets.h"

#include "search/promise_order.h"
#include "search/acting_members.h"

#include <algorithm>

namespace lacuna {

Entries without_member(const Entries& added, std::size_t member) {
  Entries rest = added;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(member));
  return rest;
}

bool is_twice(const Entries& added, const RobotSpec& robot) {
  const Entries placed = placed_entries(added, robot);
  return members_of(placed).size() < placed.size();
}

std::vector<const FittedModel*> FittedSets::candidates() const {
  std::vector<const FittedModel*> sets = {&models_.base()};
  for (const auto& [members, model] : models_.all())
    if (!members.empty() && members.size() <= kMostMembers) sets.push_back(&model);
  return sets;
}

std::vector<CandidateSet> FittedSets::judged() const {
  std::vector<CandidateSet> sets;
  for (const FittedModel* set : candidates()) {
    sets.push_back(set->judged);
    sets.back().idle = idle_members(*set, models_.ladder().layout, look_);
  }
  return sets;
}

std::vector<const FittedModel*> FittedSets::ordered(std::size_t size) const {
  std::vector<const FittedModel*> sets;
  for (const auto& [members, model] : models_.all())
    if (members.size() == size) sets.push_back(&model);
  const double worth = kWorthOfAValue * whole_gain();
  const auto price = [&](const FittedModel* set) { return set->judged.cost.cost + worth * set->judged.told; };
  std::sort(sets.begin(), sets.end(), [&](const FittedModel* a, const FittedModel* b) { return price(a) < price(b); });
  return sets;
}

const FittedModel* FittedSets::best() const {
  const FittedModel* best = &models_.base();
  for (const auto& [members, model] : models_.all())
    if (model.judged.cost.cost < best->judged.cost.cost) best = &model;
  return best;
}

double FittedSets::whole_gain() const {
  double gain = 0.0;
  for (const auto& [members, model] : models_.all())
    gain = std::max(gain, gain_of(model.judged, models_.base().judged).nats);
  return gain;
}

bool FittedSets::does_the_same(const FittedModel& one, const FittedModel& other) const {
  const Eigen::VectorXd gain = models_.base().judged.cost.by_block() - other.judged.cost.by_block();
  return (one.judged.cost.by_block() - other.judged.cost.by_block()).norm() < kSame * gain.norm();
}

bool FittedSets::gains_by_both(const FittedModel& pair) const {
  const double worth = kWorthATriple * whole_gain();
  return std::all_of(pair.model.added.begin(), pair.model.added.end(), [&](const EffectEntry& entry) {
    const FittedModel* part = models_.find({member_name(entry)});
    return !part || gain_of(pair.judged, part->judged).nats > worth;
  });
}

}  // namespace lacuna
