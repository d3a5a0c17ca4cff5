#include "diagnosis/diagnosis.h"

#include "diagnosis/data_doubts.h"
#include "diagnosis/effect_search.h"

#include <algorithm>

namespace lacuna {

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothing_missing: return "nothing_missing";
    case Verdict::effect_found: return "effect_found";
    case Verdict::not_in_library: return "not_in_library";
    case Verdict::cannot_tell: return "cannot_tell";
  }
  return "";
}

Diagnosis diagnose(const DiagnosisTask& task) {
  const bool saturation_is_tried =
      task.among.empty() || std::find(task.among.begin(), task.among.end(), "sensor_saturation") != task.among.end();
  const std::vector<Doubt> doubts =
      data_doubts({task.definition, task.model, task.trials, task.values, saturation_is_tried});
  Diagnosis result = disqualifying(doubts).empty() ? search_effects(task) : Diagnosis{};
  for (const Doubt& doubt : doubts) result.findings.push_back(doubt.sentence);
  return result;
}

}  // namespace lacuna
