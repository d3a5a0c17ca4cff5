#include "figures/withheld_table.h"

#include "dirty/dirty_kind.h"
#include "dirty/dirty_plan.h"
#include "figures/dirty_scores.h"
#include "figures/dirty_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace hidden_effects {
namespace {

dirty::DirtyPlan plan_of(const CaseResult& result) {
  return dirty::plan_dirty_cases(result.about.set).at(static_cast<std::size_t>(result.about.number));
}

const DirtyEffectRecord* main_effect(const CaseResult& result) {
  const auto found = std::find_if(result.dirty.begin(), result.dirty.end(),
                                  [](const DirtyEffectRecord& one) { return one.role == "main"; });
  return found == result.dirty.end() ? nullptr : &*found;
}

/// What an answer says that the unexplained force goes with; empty: it tells none.
std::string told_words(const CaseResult& result) {
  if (result.diagnoses.empty()) return "";
  const auto document = nlohmann::json::parse(result.diagnoses.front().json);
  return document.contains("unexplained") ? document["unexplained"]["depends_on"].get<std::string>() : "";
}

struct Counts {
  int cases = 0, ended = 0, told = 0, named = 0, right = 0;
};

Counts counts_of(const std::vector<CaseResult>& results, bool withheld, bool disturbed) {
  Counts counts;
  for (const CaseResult& one : results) {
    const ForceVerdict verdict = force_verdict_of(one);
    if (verdict.withheld != withheld || verdict.disturbed != disturbed) continue;
    ++counts.cases;
    counts.ended += verdict.ended ? 1 : 0;
    counts.told += verdict.told ? 1 : 0;
    counts.named += verdict.told && verdict.named ? 1 : 0;
    counts.right += grade_of(one) == DirtyGrade::right ? 1 : 0;
  }
  return counts;
}

std::string counts_row(const std::string& name, const Counts& counts, bool withheld) {
  return fmt::format("| {} | {} | {} | {} | {} | {} |\n", name, counts.cases, counts.told, counts.named, counts.ended,
                     withheld ? "" : std::to_string(counts.right));
}

std::string withheld_row(const CaseResult& result) {
  const ForceVerdict verdict = force_verdict_of(result);
  const DirtyEffectRecord* hidden = main_effect(result);
  const std::string law = hidden ? fmt::format("{} @ {}", hidden->what, hidden->answer.place) : "–";
  return fmt::format("| {} | {} | {:.1f} | {} | {} | {} | {} | {} | {} |\n", result.about.number, result.about.rig,
                     result.about.strength, verdict.withheld ? "withheld" : "there",
                     verdict.disturbed ? "random forces" : "", law, answered(result), told_words(result),
                     verdict.told ? (verdict.named ? "yes" : "no") : "");
}

}  // namespace

ForceVerdict force_verdict_of(const CaseResult& result) {
  const dirty::DirtyPlan plan = plan_of(result);
  ForceVerdict verdict{plan.withheld, plan.disturbance > 0.0};
  if (result.diagnoses.empty()) return verdict;
  verdict.ended = result.diagnoses.front().verdict == "not_in_library";
  const std::string told = told_words(result);
  verdict.told = !told.empty();
  if (const DirtyEffectRecord* hidden = main_effect(result)) {
    const std::vector<std::string> right = goes_with(dirty::dirty_kind(hidden->what));
    verdict.named = std::find(right.begin(), right.end(), told) != right.end();
  }
  return verdict;
}

std::string withheld_tables(const std::vector<CaseResult>& results) {
  std::string text =
      "| the law is | n | unexplained force told | goes with the right thing | not_in_library | right |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const bool withheld : {true, false})
    for (const bool disturbed : {false, true})
      text += counts_row(
          fmt::format("{}{}", withheld ? "withheld" : "in the library", disturbed ? ", random forces act" : ""),
          counts_of(results, withheld, disturbed), withheld);
  text +=
      "\n| case | family | error / noise | library | | law | answer | told to go with | right |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const CaseResult& one : results) text += withheld_row(one);
  return text;
}

}  // namespace hidden_effects
