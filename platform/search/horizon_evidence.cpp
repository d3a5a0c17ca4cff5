#include "search/horizon_evidence.h"

#include "search/decisions.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMostSure = 10.0;  ///< standard errors; more is no surer
constexpr double kSmallest = 1e-3;  ///< nats
constexpr double kMostTimesFloor = 100.0;

double sureness(const CostDifference& difference) {
  if (!(difference.error > 0.0)) return difference.nats > 0.0 ? kMostSure : 0.0;
  return std::clamp(difference.nats / difference.error, 0.0, kMostSure);
}

/// Whether a set has every effect of the answer, or one in its place that the data do not tell from it.
bool is_of_class(const RankedSet& set, const Missing& missing) {
  const std::vector<EffectEntry>& answer = missing.ranking[missing.answer].model.added;
  const auto of_answer = [&](const EffectEntry& entry) {
    const std::string name = name_of_set({entry});
    return missing.alike.contains(name) || std::any_of(answer.begin(), answer.end(), [&](const EffectEntry& one) {
             return name_of_set({one}) == name;
           });
  };
  const auto count = std::count_if(set.model.added.begin(), set.model.added.end(), of_answer);
  return static_cast<std::size_t>(count) >= answer.size();
}

/// By how much, in standard errors, the answer is ahead of the nearest set that says something else with no more
/// values.
double lead(const Missing& missing) {
  const std::size_t values = missing.ranking[missing.answer].model.definition.free.size();
  double least = kMostSure;
  for (const RankedSet& set : missing.ranking)
    if (set.model.definition.free.size() <= values && !is_of_class(set, missing))
      least = std::min(least, sureness(set.over_answer));
  return least;
}

/// What the answer leaves of the error above the floor, in logarithms.
double left(const Missing& missing) {
  const double before = std::log(times_floor(missing.ladder, missing.base.errors));
  const double now = std::log(times_floor(missing.ladder, missing.ranking[missing.answer].errors));
  return before > 0.0 ? std::clamp(now / before, 0.0, 1.0) : 0.0;
}

}  // namespace

Evidence evidence_of(const Missing& missing, const std::vector<HorizonError>& horizons) {
  const RankedSet& answer = missing.ranking[missing.answer];
  Evidence evidence;
  if (answer.model.added.empty()) return evidence;
  evidence["log_gain"] = std::log10(std::max(kSmallest, answer.over_base.nats));
  evidence["sureness"] = sureness(answer.over_base);
  evidence["lead"] = lead(missing);
  evidence["improved"] = where_answer_helps(horizons).share();
  evidence["left"] = left(missing);
  evidence["log_error"] = std::log10(std::clamp(times_floor(missing.ladder, answer.errors), 0.1, kMostTimesFloor));
  evidence["further_effects"] = static_cast<double>(answer.model.added.size()) - 1.0;
  evidence["look_alikes"] = static_cast<double>(missing.alike.size());
  std::erase_if(evidence, [](const auto& one) { return !std::isfinite(one.second); });
  return evidence;
}

}  // namespace lacuna
