#include "figures/dirty_scores.h"

#include "answer/calibration.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace hidden_effects {
namespace {

bool accepts(const DirtyEffectRecord& effect, const EffectAt& said) {
  return std::any_of(effect.accepted.begin(), effect.accepted.end(),
                     [&](const std::string& one) { return names_effect(said, one); });
}

/// How many of the needed effects are named, and how many by look-alikes alone; how many strangers there are.
struct Naming {
  std::size_t named = 0, stood_for = 0, strangers = 0;
};

Naming naming_of(const CaseResult& result, const RankedModelRecord& model) {
  Naming naming;
  for (const DirtyEffectRecord* effect : needed_effects(result)) {
    const bool itself = std::any_of(model.effects.begin(), model.effects.end(),
                                    [&](const RankedEffectRecord& one) { return accepts(*effect, one.what); });
    const bool alike = std::any_of(model.look_alikes.begin(), model.look_alikes.end(),
                                   [&](const EffectAt& one) { return accepts(*effect, one); });
    naming.named += itself || alike ? 1 : 0;
    naming.stood_for += !itself && alike ? 1 : 0;
  }
  for (const RankedEffectRecord& one : model.effects) {
    const bool present = std::any_of(result.dirty.begin(), result.dirty.end(), [&](const DirtyEffectRecord& effect) {
      return effect.share >= kPresentShare && accepts(effect, one.what);
    });
    naming.strangers += present ? 0 : 1;
  }
  naming.strangers -= std::min(naming.strangers, naming.stood_for);
  return naming;
}

DirtyGrade grade_found(const CaseResult& result, const RankedModelRecord& model) {
  const Naming naming = naming_of(result, model);
  if (naming.named == 0) return DirtyGrade::wrong;
  const bool all = naming.named == needed_effects(result).size();
  return all && naming.strangers <= 1 ? DirtyGrade::right : DirtyGrade::half;
}

/// What the shipped calibration says of an answer that was fitted without its family; NaN where it says nothing.
double probability_without_family(const CaseResult& result) {
  const lacuna::ShippedCalibration& shipped = lacuna::shipped_calibration();
  const auto family = shipped.without.find(result.about.rig);
  const lacuna::Calibration& calibration = family == shipped.without.end() ? shipped.all : family->second;
  const DiagnosisRecord& answer = result.diagnoses.front();
  const auto verdict = calibration.find(answer.verdict);
  if (verdict == calibration.end()) return kUnknown;
  return verdict->second.probability(nlohmann::json::parse(answer.json).value("evidence", lacuna::Evidence{}));
}

}  // namespace

const char* to_string(DirtyGrade grade) {
  switch (grade) {
    case DirtyGrade::right: return "right";
    case DirtyGrade::half: return "half";
    case DirtyGrade::undecided: return "undecided";
    case DirtyGrade::wrong: return "wrong";
    case DirtyGrade::failed: return "failed";
  }
  return "";
}

bool names_effect(const EffectAt& said, const std::string& accepted) {
  if (accepted == said.effect || accepted == said.effect + " @ " + said.place) return true;
  return said.place.ends_with(".*") &&
         accepted.starts_with(said.effect + " @ " + said.place.substr(0, said.place.size() - 1));
}

std::vector<const DirtyEffectRecord*> needed_effects(const CaseResult& result) {
  std::vector<const DirtyEffectRecord*> needed;
  if (!(result.about.strength >= kLeastError)) return needed;
  for (const DirtyEffectRecord& one : result.dirty)
    if (one.share >= kNeededShare) needed.push_back(&one);
  return needed;
}

DirtyGrade grade_of(const CaseResult& result) {
  if (!result.failure.empty() || result.diagnoses.empty()) return DirtyGrade::failed;
  const DiagnosisRecord& answer = result.diagnoses.front();
  if (answer.verdict == "cannot_tell") return DirtyGrade::undecided;
  const std::vector<const DirtyEffectRecord*> needed = needed_effects(result);
  if (needed.empty()) return answer.verdict == "nothing_missing" ? DirtyGrade::right : DirtyGrade::wrong;
  if (answer.verdict == "not_in_library") {
    const bool other_form = std::any_of(needed.begin(), needed.end(),
                                        [](const DirtyEffectRecord* effect) { return !effect->library_form; });
    return other_form ? DirtyGrade::half : DirtyGrade::wrong;
  }
  if (answer.verdict != "effect_found" || answer.ranking.empty()) return DirtyGrade::wrong;
  return grade_found(result, answer.ranking.front());
}

bool is_true(const CaseResult& result) {
  const DirtyGrade grade = grade_of(result);
  const bool ends_library = grade == DirtyGrade::half && result.diagnoses.front().verdict == "not_in_library";
  return grade == DirtyGrade::right || ends_library;
}

BrierScores brier_of(const std::vector<CaseResult>& results) {
  double squares = 0.0, of_left_out = 0.0, right = 0.0;
  BrierScores scores;
  for (const CaseResult& one : results) {
    const DirtyGrade grade = grade_of(one);
    if (grade == DirtyGrade::failed || grade == DirtyGrade::undecided) continue;
    const double probability = one.diagnoses.front().probability, outcome = is_true(one) ? 1.0 : 0.0;
    if (std::isnan(probability)) continue;
    squares += std::pow(probability - outcome, 2);
    of_left_out += std::pow(probability_without_family(one) - outcome, 2);
    right += outcome;
    ++scores.count;
  }
  if (scores.count == 0) return scores;
  const double share = right / scores.count;
  scores.stated = squares / scores.count;
  scores.left_out = of_left_out / scores.count;
  scores.constant = share * (1.0 - share);
  return scores;
}

std::string commonest_effect(const std::vector<CaseResult>& results) {
  std::map<std::string, int> counts;
  for (const CaseResult& result : results)
    for (const DirtyEffectRecord* effect : needed_effects(result))
      if (!effect->answer.effect.starts_with("value ")) ++counts[effect->answer.effect];
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? "" : most->first;
}

DirtyGrade grade_of_constant(const CaseResult& result, const std::string& effect) {
  const std::vector<const DirtyEffectRecord*> needed = needed_effects(result);
  std::size_t named = 0;
  for (const DirtyEffectRecord* one : needed)
    named += std::any_of(one->accepted.begin(), one->accepted.end(),
                         [&](const std::string& name) { return name.starts_with(effect + " @ "); });
  if (named == 0) return DirtyGrade::wrong;
  return named == needed.size() ? DirtyGrade::right : DirtyGrade::half;
}

}  // namespace hidden_effects
