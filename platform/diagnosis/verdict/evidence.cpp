#include "diagnosis/verdict/evidence.h"

#include "diagnosis/rounds/ranking.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kLeastP = 5e-4;    ///< what draws of noise resolve
constexpr double kMostSure = 10.0;  ///< standard errors; more is no surer

/// By how much the answer is ahead of the best model that is not named beside it, nats.
double lead(const std::vector<RankedModel>& ranking) {
  const RankedModel& answer = ranking.front();
  double best = 0.0;
  for (std::size_t i = 1; i < ranking.size(); ++i)
    if (std::none_of(answer.look_alikes.begin(), answer.look_alikes.end(),
                     [&](const std::string& name) { return is_last_effect(ranking[i], name); }))
      best = std::max(best, ranking[i].gain.value);
  return std::max(0.0, answer.gain.value - best);
}

double sureness(const Gain& gain) {
  if (!(gain.standard_error > 0.0)) return gain.value > 0.0 ? kMostSure : 0.0;
  return std::clamp(gain.value / gain.standard_error, 0.0, kMostSure);
}

void add_answer(const Diagnosis& diagnosis, bool steady, Evidence& evidence) {
  const RankedModel& answer = diagnosis.ranking.front();
  evidence["log_gain"] = std::log10(std::max(1.0, gained(diagnosis.answer_gain)));
  evidence["sureness"] = sureness(diagnosis.answer_gain.value_or(Gain()));
  evidence["log_lead"] = std::log10(1.0 + lead(diagnosis.ranking));
  evidence["further_effects"] = static_cast<double>(answer.effects.size()) - 1.0;
  evidence["look_alikes"] = static_cast<double>(answer.look_alikes.size());
  evidence["unsteady"] = steady ? 0.0 : 1.0;
  evidence["log_error"] = std::log10(std::clamp(answer.times_floor, 0.1, 100.0));
}

}  // namespace

Evidence evidence_of(const Diagnosis& diagnosis, bool steady) {
  Evidence evidence;
  evidence["surprise"] = -std::log10(std::max(kLeastP, diagnosis.p_by_chance.value_or(1.0)));
  evidence["structure"] = -std::log10(std::max(kLeastP, diagnosis.free_force_p.value_or(1.0)));
  evidence["log_base_error"] = std::log10(std::clamp(diagnosis.base_times_floor, 0.1, 100.0));
  if (!diagnosis.ranking.empty() && !diagnosis.ranking.front().effects.empty()) add_answer(diagnosis, steady, evidence);
  std::erase_if(evidence, [](const auto& one) { return !std::isfinite(one.second); });
  return evidence;
}

}  // namespace lacuna
