#include "runs/settling_question.h"

#include <algorithm>

namespace hidden_effects {
namespace {

bool is_found(const DiagnosisRecord& diagnosis) {
  return diagnosis.verdict == "effect_found" && !diagnosis.ranking.empty() &&
         !diagnosis.ranking.front().effects.empty();
}

bool names_effect(const RankedModelRecord& model, const EffectAt& what) {
  return std::find(model.look_alikes.begin(), model.look_alikes.end(), what) != model.look_alikes.end() ||
         std::any_of(model.effects.begin(), model.effects.end(),
                     [&](const RankedEffectRecord& effect) { return effect.what == what; });
}

}  // namespace

std::optional<SettlingQuestion> question_of(const DiagnosisRecord& diagnosis) {
  if (!is_found(diagnosis) || diagnosis.next_test.empty()) return std::nullopt;
  const RankedModelRecord& answer = diagnosis.ranking.front();
  if (answer.look_alikes.empty()) return std::nullopt;
  SettlingQuestion question{answer.effects.back().what, answer.look_alikes.front(), {}};
  for (const RankedEffectRecord& effect : answer.effects) question.among.push_back(effect.what.effect);
  question.among.push_back(question.rival.effect);
  return question;
}

EffectAt remaining(const SettlingQuestion& question, const DiagnosisRecord& diagnosis) {
  if (!is_found(diagnosis)) return {};
  const RankedModelRecord& model = diagnosis.ranking.front();
  const bool answer = names_effect(model, question.answer), rival = names_effect(model, question.rival);
  if (answer == rival) return {};
  return answer ? question.answer : question.rival;
}

}  // namespace hidden_effects
