#include "search/spread.h"

#include "candidates/wrong_value.h"
#include "criterion/evidence.h"
#include "search/fit_starts.h"
#include "search/acting_members.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::uint64_t kSeedOfSigns = 1;  ///< of signs drawn at random
constexpr const char* kOfEach = ".*";
constexpr int kRounds = 4;             ///< of fits
constexpr double kSettled = 0.01;      ///< nats
constexpr double kWorthAPlace = 0.01;  ///< of the whole gain, for each value that the data determine

bool is_tied(const EffectEntry& entry) { return entry.where.size() == 1 && entry.where.front().ends_with(kOfEach); }

/// "joint." of "joint.elbow" and "joint.*".
std::string kind_of_place(const std::string& where) { return where.substr(0, where.find('.') + 1); }

/// The same effect on each single element of the kind, where the library has it as a candidate.
std::vector<EffectEntry> on_each(const EffectEntry& entry, const EffectLook& look) {
  std::vector<EffectEntry> each;
  if (entry.where.size() != 1 || is_wrong_value(entry)) return each;
  for (const Hypothesis& one : look.hypotheses)
    if (one.entry.effect == entry.effect && !is_tied(one.entry) &&
        kind_of_place(one.where()) == kind_of_place(entry.where.front()))
      each.push_back(one.entry);
  return each;
}

bool has_member(const std::vector<EffectEntry>& entries, const EffectEntry& one) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const EffectEntry& other) { return member_name(other) == member_name(one); });
}

struct SpreadSet {
  std::vector<EffectEntry> entries;
  NamedValues start;
};

/// The start values: of an effect that was on all elements at once, its common values; else near neutral.
SpreadSet spread_set(const FittedModel& answer, const EffectLook& look) {
  SpreadSet set{{}, answer.values};
  NamedValues near_nothing;
  for (const EffectEntry& entry : answer.model.added)
    if (!is_tied(entry)) set.entries.push_back(entry);
  for (const EffectEntry& entry : answer.model.added)
    for (const EffectEntry& one : on_each(entry, look)) {
      if (has_member(set.entries, one)) continue;
      set.entries.push_back(one);
      const std::string known = member_name(entry) + ".";
      for (const auto& [name, value] : answer.values)
        if (name.starts_with(known))
          (is_tied(entry) ? set.start : near_nothing)[member_name(one) + name.substr(name.rfind('.'))] = value;
    }
  set.start = slightly(near_nothing, set.start, look);
  return set;
}

/// Repeats while that lowers the cost.
const FittedModel* refined(FittedModels& models, const std::vector<EffectEntry>& entries, const NamedValues& start) {
  const FittedModel* set = models.refine(entries, start);
  for (int round = 1; set && round < kRounds; ++round) {
    const double before = set->fit.cost;
    set = models.refine(entries, NamedValues(set->values));
    if (before - set->fit.cost < kSettled) break;
  }
  return set;
}

bool is_as_good(const CandidateSet& set, const CandidateSet& as) { return !gain_of(as, set).is_told(); }

bool is_better(const CandidateSet& set, const CandidateSet& than, double whole_gain) {
  const CostGain gain = gain_of(set, than);
  return gain.is_told() && gain.nats > kWorthAPlace * whole_gain * (set.told - than.told) &&
         gain_elsewhere(set, than).is_told() &&
         sign_probability({than.cost.by_block() - set.cost.by_block()}, kSeedOfSigns) < kPresent;
}

}  // namespace

std::optional<FittedModel> spread_over_places(FittedModels& models, const EffectLook& look, const FittedModel& answer,
                                              double whole_gain) {
  const SpreadSet all = spread_set(answer, look);
  if (all.entries.size() <= answer.model.added.size()) return std::nullopt;
  const FittedModel before = answer;
  const bool has_value_for_each = answer.model.placed.size() > answer.model.added.size();
  const bool is_spread = has_value_for_each && all.entries.size() == answer.model.placed.size();
  const FittedModel* set = is_spread ? &before : refined(models, all.entries, all.start);
  if (!set) return std::nullopt;
  std::vector<EffectEntry> told;
  std::copy_if(all.entries.begin(), all.entries.end(), std::back_inserter(told),
               [&](const EffectEntry& entry) { return acts(entry, *set, models.ladder().layout, look); });
  if (told.empty()) return std::nullopt;
  if (is_spread && told.size() == all.entries.size()) return std::nullopt;
  if (told.size() < all.entries.size()) set = refined(models, told, NamedValues(set->values));
  if (!set) return std::nullopt;
  const bool replaces =
      has_value_for_each ? is_as_good(set->judged, before.judged) : is_better(set->judged, before.judged, whole_gain);
  return replaces ? std::optional(*set) : std::nullopt;
}

}  // namespace lacuna
