#include "diagnosis/likelihoods/diagnose.h"

#include "diagnosis/data_checks/data_doubts.h"
#include "diagnosis/likelihoods/effect_search.h"
#include "diagnosis/verdict/doubted_data.h"
#include "diagnosis/verdict/stopped_search.h"
#include "foundation/interrupt.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr const char* kSaturation = "sensor_saturation";

Diagnosis without_search(const std::vector<Doubt>& doubts) {
  Diagnosis result;
  for (const Doubt& doubt : doubts) result.findings.push_back(doubt.sentence);
  return result;
}

bool is_tried(const DiagnosisTask& task) {
  return task.among.empty() || std::find(task.among.begin(), task.among.end(), kSaturation) != task.among.end();
}

bool is_found(const Diagnosis& diagnosis) {
  const auto saturates = [](const FoundEffect& effect) { return effect.effect == kSaturation; };
  return !diagnosis.ranking.empty() &&
         std::any_of(diagnosis.ranking.front().effects.begin(), diagnosis.ranking.front().effects.end(), saturates);
}

Diagnosis look_and_search(const DiagnosisTask& task) {
  DoubtTask about{task.definition, task.model, task.trials, task.values, is_tried(task)};
  std::vector<Doubt> doubts = data_doubts(about);
  if (too_little_for_likelihoods(doubts)) return without_search(doubts);
  Diagnosis result = search_effects(task);
  if (about.saturation_is_tried && !result.stopped && !is_found(result)) {  // then clipped readings are not explained
    about.saturation_is_tried = false;
    doubts = data_doubts(about);
  }
  if (!task.among.empty() && result.verdict == Verdict::not_in_library)
    result.findings.emplace_back("only the effects that were named were tried: another one of the library may have it");
  add_doubts(doubts, result);
  return result;
}

}  // namespace

Diagnosis diagnose(const DiagnosisTask& task) {
  try {
    return look_and_search(task);
  } catch (const TimeIsUp&) {
    lift_time_limit();
    return stopped_before_search(task.experiment, task.catalog, task.definition, task.among, "checks of the data");
  }
}

}  // namespace lacuna
