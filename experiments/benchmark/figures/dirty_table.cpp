#include "figures/dirty_table.h"

#include "figures/dirty_scores.h"
#include "foundation/text/figure_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace hidden_effects {
namespace {

constexpr double kSure = 0.9;
constexpr DirtyGrade kGrades[] = {DirtyGrade::right, DirtyGrade::half, DirtyGrade::undecided, DirtyGrade::wrong,
                                  DirtyGrade::failed};

using Cases = std::vector<const CaseResult*>;

double middle_of(std::vector<double> values) {
  if (values.empty()) return kUnknown;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool surely_wrong(const CaseResult& one) {
  return grade_of(one) == DirtyGrade::wrong && one.diagnoses.front().probability >= kSure;
}

std::string row_of(const std::string& name, const Cases& cases) {
  std::map<DirtyGrade, int> counts;
  std::vector<double> seconds;
  for (const CaseResult* one : cases) {
    ++counts[grade_of(*one)];
    if (!one->diagnoses.empty()) seconds.push_back(one->diagnoses.front().processor_seconds);
  }
  std::string text = fmt::format("| {} | {} |", name, cases.size());
  for (const DirtyGrade grade : kGrades) text += fmt::format(" {} |", counts[grade]);
  const auto sure = std::count_if(cases.begin(), cases.end(), [](const CaseResult* one) { return surely_wrong(*one); });
  return text + fmt::format(" {} | {:.0f} |\n", sure, middle_of(seconds));
}

std::string row_of_constant(const std::vector<CaseResult>& results) {
  const std::string effect = commonest_effect(results);
  if (effect.empty()) return "";
  std::map<DirtyGrade, int> counts;
  for (const CaseResult& one : results) ++counts[grade_of_constant(one, effect)];
  std::string text = fmt::format("| always {} | {} |", effect, results.size());
  for (const DirtyGrade grade : kGrades) text += fmt::format(" {} |", counts[grade]);
  return text + " | |\n";
}

std::string needs_text(std::size_t needed) {
  if (needed == 0) return "nothing needed";
  return needed == 1 ? "one effect needed" : "two or more needed";
}

std::string grades_table(const std::vector<CaseResult>& results) {
  std::map<std::string, Cases> families, needs;
  Cases all;
  for (const CaseResult& one : results) {
    families[one.about.rig].push_back(&one);
    needs[needs_text(needed_effects(one).size())].push_back(&one);
    all.push_back(&one);
  }
  std::string text =
      "| cases | n | right | half | undecided | wrong | failed | wrong, P ≥ 0.9 | median s |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  text += row_of("all", all);
  for (const auto& [name, cases] : needs) text += row_of(name, cases);
  for (const auto& [name, cases] : families) text += row_of(name, cases);
  return text + row_of_constant(results);
}

std::string brier_text(const std::vector<CaseResult>& results) {
  const BrierScores scores = brier_of(results);
  if (scores.count == 0) return "\nNo answer states a probability.\n";
  return fmt::format(
      "\nBrier score of {} stated probabilities: {:.3f}; fitted without the case's family: {:.3f}; of the best "
      "constant: "
      "{:.3f}.\n",
      scores.count, scores.stated, scores.left_out, scores.constant);
}

std::string needed_text(const CaseResult& result) {
  std::vector<std::string> words;
  for (const DirtyEffectRecord* one : needed_effects(result)) {
    const std::string place = one->what.starts_with("value ") ? "" : " @ " + one->answer.place;
    words.push_back(fmt::format("{}{} {:.0f} %", one->what, place, 100.0 * one->share));
  }
  return words.empty() ? "nothing" : fmt::format("{}", fmt::join(words, " + "));
}

std::string case_row(const CaseResult& result) {
  const bool told = !result.diagnoses.empty();
  const double probability = told ? result.diagnoses.front().probability : kUnknown;
  const double seconds = told ? result.diagnoses.front().processor_seconds : kUnknown;
  return fmt::format("| {} | {} | {:.1f} | {} | {} | {} | {} | {} |\n", result.about.number, result.about.rig,
                     result.about.strength, needed_text(result), answered(result),
                     lacuna::probability_text(probability), to_string(grade_of(result)),
                     std::isfinite(seconds) ? fmt::format("{:.0f}", seconds) : "–");
}

}  // namespace

std::string answered(const CaseResult& result) {
  if (result.diagnoses.empty()) return result.failure;
  const DiagnosisRecord& answer = result.diagnoses.front();
  if (answer.verdict != "effect_found" || answer.ranking.empty()) return answer.verdict;
  std::vector<std::string> words;
  for (const RankedEffectRecord& one : answer.ranking.front().effects)
    words.push_back(one.what.effect + " @ " + one.what.place);
  return fmt::format("{}", fmt::join(words, " + "));
}

std::string dirty_tables(const std::vector<CaseResult>& results) {
  std::string text = grades_table(results) + brier_text(results);
  text +=
      "\n| case | family | error / noise | needed | answer | P | grade | s |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const CaseResult& one : results) text += case_row(one);
  return text;
}

}  // namespace hidden_effects
