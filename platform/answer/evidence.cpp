#include "answer/evidence.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr double kMostSure = 10.0;  ///< standard errors; more is no surer
constexpr double kSmallest = 1e-3;  ///< nats

double sureness(const CostGain& gain) {
  if (!(gain.error > 0.0)) return gain.nats > 0.0 ? kMostSure : 0.0;
  return std::clamp(gain.nats / gain.error, 0.0, kMostSure);
}

const FittedModel& answer_of(const SearchResult& found) { return found.sets[found.decision.answer]; }

/// By how much, in standard errors, the answer is ahead of the nearest set that says something else with no more
/// values.
double lead(const SearchResult& found) {
  const FittedModel& answer = answer_of(found);
  std::set<std::string> of_class = answer.judged.members;
  for (const std::string& name : look_alikes_of(found)) of_class.insert(name);
  double least = kMostSure;
  for (const FittedModel& set : found.sets) {
    const std::set<std::string>& members = set.judged.members;
    const bool is_other =
        std::any_of(members.begin(), members.end(), [&](const std::string& name) { return !of_class.contains(name); });
    if (is_other && set.judged.told <= answer.judged.told)
      least = std::min(least, sureness(gain_of(answer.judged, set.judged)));
  }
  return least;
}

}  // namespace

std::vector<std::string> look_alikes_of(const SearchResult& found) {
  std::set<std::string> names;
  for (const std::size_t i : found.decision.alike)
    for (const std::string& name : found.sets[i].judged.members)
      if (!answer_of(found).judged.members.contains(name)) names.insert(name);
  return {names.begin(), names.end()};
}

Evidence evidence_of(const SearchResult& found) {
  const FittedModel& answer = answer_of(found);
  const double before = found.sets.front().judged.cost.cost, after = answer.judged.cost.cost;
  Evidence evidence = {{"surprise", -std::log10(found.decision.p)},
                       {"base_cost", before},
                       {"nested_sets", found.nested},
                       {"unnested_sets", found.unnested}};
  if (found.decision.answer == 0) return evidence;
  evidence["log_gain"] = std::log10(std::max(kSmallest, found.decision.gain.nats));
  evidence["sureness"] = sureness(found.decision.gain);
  evidence["lead"] = lead(found);
  evidence["left"] = before > 0.0 ? std::clamp(after / before, 0.0, 1.0) : 0.0;
  evidence["share"] = found.decision.gain.nats / std::max(kSmallest, found.decision.whole_gain);
  evidence["further_effects"] = static_cast<double>(answer.judged.members.size()) - 1.0;
  evidence["look_alikes"] = static_cast<double>(look_alikes_of(found).size());
  evidence["all_lengths"] = found.by_all_lengths ? 1.0 : 0.0;
  return evidence;
}

}  // namespace lacuna
