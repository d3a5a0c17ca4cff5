#include "measured_rigs/rig_results.h"

#include "foundation/text/figure_text.h"
#include "foundation/files/whole_file.h"
#include "measured_rigs/set_scores.h"
#include "runs/case_failure.h"
#include "runs/child_process.h"
#include "runs/read_results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The last line of what a program complained of.
std::string complaint_of(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

RigResult told(RigResult result, const json& kept) {
  result.seconds = kept.at("seconds");
  result.failure = kept.at("failure");
  if (const json& over = kept.at("over_check"); over.is_number()) result.over_check = over;
  if (result.failure.empty()) result.diagnosis = read_diagnosis(kept.at("diagnosis").dump());
  return result;
}

/// Geometric mean over horizons and channels of what the answer leaves of the errors on held-out recordings.
double held_out_ratio(const DiagnosisRecord& diagnosis) {
  const json document = json::parse(diagnosis.json);
  double sum = 0.0, count = 0.0;
  for (const json& one : document.value("horizons", json::array())) {
    if (!one["base_held_out"].is_number() || !one["answer_held_out"].is_number()) continue;
    sum += std::log(one["answer_held_out"].get<double>() / one["base_held_out"].get<double>());
    count += 1.0;
  }
  return count > 0.0 ? std::exp(sum / count) : kUnknown;
}

std::vector<std::string> effects_of(const DiagnosisRecord& diagnosis) {
  std::vector<std::string> names;
  if (diagnosis.verdict == "effect_found" && !diagnosis.ranking.empty())
    for (const RankedEffectRecord& effect : diagnosis.ranking.front().effects)
      names.push_back(effect.what.effect + " @ " + effect.what.place);
  return names;
}

/// Held-out error of what was found over that of the check's model.
double over_check(const AcceptedAnswer& accepted, const std::string& experiment, const fs::path& folder,
                  const DiagnosisRecord& diagnosis) {
  const std::vector<std::string> found = effects_of(diagnosis);
  if (accepted.check.empty() || found.empty()) return kUnknown;
  const std::vector<double> costs = held_out_costs(folder / experiment, {found, accepted.check});
  return std::exp(costs.front() - costs.back());
}

std::string change_text(double ratio) { return lacuna::error_change_text(ratio, 1.0); }

std::string answer_text(const RigResult& result) {
  if (!result.diagnosis) return result.failure;
  const DiagnosisRecord& diagnosis = *result.diagnosis;
  const std::vector<std::string> names = effects_of(diagnosis);
  return names.empty() ? diagnosis.verdict : fmt::format("{}", fmt::join(names, " + "));
}

bool is_right(const RigResult& result) {
  return result.diagnosis && grade(*result.accepted, result.experiment, *result.diagnosis) == Grade::right;
}

std::string grade_text(const RigResult& result) {
  if (!result.diagnosis) return "failed";
  switch (grade(*result.accepted, result.experiment, *result.diagnosis)) {
    case Grade::right: return "right";
    case Grade::wrong: return "wrong";
    case Grade::undecided: return "undecided";
  }
  return "";
}

}  // namespace

RigResult run_rig(const AcceptedAnswer& accepted, const std::string& experiment, const fs::path& folder,
                  const ProgramSettings& settings, const std::string& identity) {
  const RigResult result{&accepted, experiment, "", {}, kUnknown};
  const fs::path file = folder / (fs::path(experiment).stem().string() + ".result.json");
  if (fs::exists(file))
    if (const json kept = json::parse(text_of(file), nullptr, false);
        kept.is_object() && kept.value("identity", "") == identity)
      return told(result, kept);
  const ChildOutcome outcome =
      run_child({settings.lacuna.string(), "diagnose", experiment, "--quiet", "--json=found.json"}, folder,
                settings.longest, settings.stop);
  if (outcome.stopped) throw CaseStopped();
  json kept = {{"identity", identity}, {"seconds", outcome.seconds}, {"failure", ""}, {"over_check", nullptr}};
  if (outcome.timed_out)
    kept["failure"] = fmt::format("no answer within {:.0f} s", settings.longest);
  else if (outcome.code != 0)
    kept["failure"] = fmt::format("exit code {}: {}", outcome.code, complaint_of(outcome.errors));
  else {
    kept["diagnosis"] = json::parse(text_of(folder / "found.json"));
    const double over = over_check(accepted, experiment, folder, read_diagnosis(kept["diagnosis"].dump()));
    if (std::isfinite(over)) kept["over_check"] = over;
  }
  lacuna::write_whole(file, kept.dump(1), lacuna::Link::replaced);
  return told(result, kept);
}

std::string table_of(const std::vector<RigResult>& results) {
  std::string text =
      "| experiment | | answer | not fitted | held out | over the check's | s |\n| --- | --- | --- | --- | --- | --- | "
      "--- |\n";
  std::map<std::string, bool> rigs;
  for (const RigResult& one : results) {
    const bool found = one.diagnosis && one.diagnosis->verdict == "effect_found" && !one.diagnosis->ranking.empty();
    const double held_out = one.diagnosis ? held_out_ratio(*one.diagnosis) : kUnknown;
    const bool by_horizon = std::isfinite(held_out);
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {:.0f} |\n", one.experiment, grade_text(one), answer_text(one),
                        change_text(found && by_horizon ? std::exp(-one.diagnosis->ranking.front().gain) : kUnknown),
                        change_text(found ? held_out : kUnknown), change_text(one.over_check), one.seconds);
    const auto [rig, is_new] = rigs.emplace(one.accepted->rig, true);
    rig->second = rig->second && is_right(one);
  }
  int right = 0;
  for (const auto& [name, is_all_right] : rigs) right += is_all_right ? 1 : 0;
  return text + fmt::format("\n{} of {} rigs right\n", right, rigs.size());
}

}  // namespace hidden_effects
