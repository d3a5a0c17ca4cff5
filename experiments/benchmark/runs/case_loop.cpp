#include "runs/case_loop.h"

#include <algorithm>

namespace hidden_effects {
namespace {

using Comparison = ReadComparison;

void note_held_out(const char* stage, const Comparison& comparison, CaseResult& result) {
  for (const NamedValue& one : comparison.held_out) result.held_out.push_back({stage, one.name, one.value});
}

/// As the last diagnosis states them.
void note_free_values(const CaseTask& task, CaseResult& result) {
  for (const IntervalRecord& value : result.diagnoses.back().values) {
    const auto known = std::find_if(task.free_values.begin(), task.free_values.end(),
                                    [&](const NamedValue& one) { return one.name == value.parameter; });
    if (known != task.free_values.end()) result.free_values.push_back({value, known->value});
  }
}

bool is_in(const EffectAt& what, const CaseResult& result) {
  return std::any_of(result.diagnoses.begin(), result.diagnoses.end(), [&](const DiagnosisRecord& one) {
    return std::find(one.added.begin(), one.added.end(), what) != one.added.end();
  });
}

/// Adds the answer's effects that the model does not have yet; false where there are none.
bool add_answer(UserSession& session, CaseResult& result) {
  const DiagnosisRecord answer = result.diagnoses.back();
  if (answer.verdict != "effect_found" || answer.ranking.empty()) return false;
  for (const RankedEffectRecord& effect : answer.ranking.front().effects) {
    if (is_in(effect.what, result)) continue;
    session.add(effect.what);
    result.diagnoses.back().added.push_back(effect.what);
  }
  return !result.diagnoses.back().added.empty();
}

void use_program(const CaseTask& task, const ProgramSettings& settings, UserSession& session, CaseResult& result) {
  const Comparison base = session.compare();
  note_held_out("base", base, result);
  for (int round = 1; round <= settings.most_diagnoses; ++round) {
    result.diagnoses.push_back(session.diagnose());
    result.diagnoses.back().round = round;
    if (round == settings.most_diagnoses || !add_answer(session, result)) break;
  }
  const bool changed = !result.diagnoses.front().added.empty();
  const Comparison last = changed ? session.compare() : base;
  note_held_out("found", last, result);
  note_free_values(task, result);
}

}  // namespace

CaseResult go_through(const CaseTask& task, const ProgramSettings& settings) {
  CaseResult result{task.about, {}, {}, {}, {}, {}, {}, {}, {}};
  UserSession session(settings, task.folder, task.withheld);
  try {
    use_program(task, settings, session, result);
  } catch (const CaseFailure& error) {  // what else goes wrong says nothing of the program
    result.failure = error.what();
  }
  return result;
}

}  // namespace hidden_effects
