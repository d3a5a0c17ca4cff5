#include "documents/diagnosis_json.h"

#include "documents/setup_json.h"
#include "foundation/text/json_depth.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

double figure(const ordered_json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<double> numbers(const ordered_json& json) {
  std::vector<double> all;
  for (const ordered_json& one : json) all.push_back(figure(one));
  return all;
}

Verdict verdict_of(const std::string& text) {
  for (const Verdict verdict : {Verdict::nothing_missing, Verdict::effect_found, Verdict::not_in_library})
    if (to_string(verdict) == text) return verdict;
  return Verdict::cannot_tell;
}

/// Empty if the document does not have it: it was not computed, or an older version wrote the document.
ordered_json list_of(const ordered_json& whole, const char* name) { return whole.value(name, ordered_json::array()); }

Gain gain_of(const ordered_json& value, const ordered_json& error, const ordered_json& interval) {
  return {figure(value), figure(error), figure(interval[0]), figure(interval[1])};
}

std::optional<double> asked_figure(const ordered_json& json, const char* name) {
  return json.contains(name) ? std::optional(figure(json[name])) : std::nullopt;
}

/// What is written under one of two names (diagnosis_json.cpp).
const ordered_json& either(const ordered_json& json, const char* one, const char* other) {
  return json[json.contains(one) ? one : other];
}

double ratio_of(const ordered_json& json) { return figure(either(json, "fitted_ratio_to_floor", "ratio_to_floor")); }

Gain gain_of(const ordered_json& json) { return gain_of(json["value"], json["standard_error"], json["ci95"]); }

/// `of`: the base, or a ranked model, which may have a floor of its own.
std::vector<ChannelError> errors_of(const ordered_json& whole, const ordered_json& of) {
  const ordered_json& floor = of.contains("noise_floor") ? of["noise_floor"] : whole["noise_floor"];
  const ordered_json& other = either(of, "held_out_rmse", "cv_rmse");
  std::vector<ChannelError> errors;
  for (const auto& [channel, unit] : whole["units"].items())
    if (floor.contains(channel))  // a model whose errors were not told yet has none
      errors.push_back(
          {channel, unit, figure(floor[channel]), figure(of["fit_rmse"][channel]), figure(other[channel])});
  return errors;
}

std::vector<FoundParameter> parameters_of(const ordered_json& json) {
  std::vector<FoundParameter> all;
  for (const auto& [name, one] : json.items()) {
    all.push_back({name, one["unit"], figure(one["value"]), figure(one["ci95"][0]), figure(one["ci95"][1])});
    if (one.contains("stated")) all.back().stated = figure(one["stated"]);
    all.back().at_bound = one.value("at_bound", false);
  }
  return all;
}

FoundEffect effect_of(const ordered_json& json) {
  FoundEffect effect{json["effect"], json["where"], parameters_of(json["parameters"])};
  if (json.contains("held"))
    for (const auto& [name, one] : json["held"].items())
      effect.held.push_back({name, one["unit"], figure(one["value"])});
  return effect;
}

RankedModel model_of(const ordered_json& whole, const ordered_json& json) {
  RankedModel model;
  for (const ordered_json& effect : json["effects"]) model.effects.push_back(effect_of(effect));
  model.look_alikes = json["class"].get<std::vector<std::string>>();
  model.gain = gain_of(json["gain"], json["gain_standard_error"], json["gain_ci95"]);
  model.errors = errors_of(whole, json);
  model.times_floor = ratio_of(json);
  model.segment = json.value("segment_s", 0.0);
  return model;
}

HorizonError horizon_of(const ordered_json& json) {
  return {figure(json["horizon_s"]),
          json["channel"],
          json["unit"],
          figure(json["floor"]),
          figure(json["base"]),
          figure(json["answer"]),
          figure(json["base_held_out"]),
          figure(json["answer_held_out"])};
}

ForceFormula formula_of(const ordered_json& json) {
  ForceFormula formula{json["joint"], json["unit"], {}, gain_of(json["gain"])};
  for (const ordered_json& term : json["terms"])
    formula.terms.push_back({term["text"], term["unit"], figure(term["coefficient"]), figure(term["standard_error"])});
  return formula;
}

ForceCurve curve_of(const ordered_json& json) {
  ForceCurve curve = {json["joint"],
                      json["of"],
                      json["unit"],
                      json["force_unit"],
                      numbers(json["at"]),
                      numbers(json["force"]),
                      numbers(json["standard_error"])};
  if (json.contains("position")) curve.position = figure(json["position"]);
  if (json.contains("by_answer")) curve.by_answer = numbers(json["by_answer"]);
  return curve;
}

UnexplainedForce unexplained_of(const ordered_json& json) {
  return {json["joint"], json["depends_on"], figure(json["share"]), gain_of(json["gain"])};
}

/// Documents of before do not name it: then what they have tells it. Nothing: nothing was searched.
std::optional<DiagnosisMethod> method_of(const ordered_json& whole) {
  if (whole.contains("method")) return read_method(whole["method"].get<std::string>());
  if (!list_of(whole, "horizons").empty()) return DiagnosisMethod::horizon;
  return whole.contains("base") ? std::optional(DiagnosisMethod::likelihood) : std::nullopt;
}

StoppedSearch stop_of(const ordered_json& json) {
  return {json["during"], json["not_examined"].get<std::vector<std::string>>(), json["next"]};
}

}  // namespace

Diagnosis read_diagnosis(const std::string& document) {
  const ordered_json whole = ordered_json::parse(shallow_json(document));
  Diagnosis diagnosis;
  diagnosis.verdict = verdict_of(whole["verdict"]);
  diagnosis.probability = figure(whole["probability"]);
  diagnosis.calibrated = whole.value("calibrated", false);
  diagnosis.method = method_of(whole);
  diagnosis.evidence = whole.value("evidence", Evidence{});
  for (const ordered_json& one : list_of(whole, "horizons")) diagnosis.horizons.push_back(horizon_of(one));
  if (whole.contains("base")) {  // else nothing was searched
    diagnosis.base = errors_of(whole, whole["base"]);
    diagnosis.base_times_floor = ratio_of(whole["base"]);
    diagnosis.base_segment = whole["base"].value("segment_s", 0.0);
  }
  for (const ordered_json& one : whole["ranking"]) diagnosis.ranking.push_back(model_of(whole, one));
  diagnosis.values = parameters_of(whole.value("values", ordered_json::object()));
  diagnosis.p_by_chance = asked_figure(whole, "p_by_chance");
  if (whole.contains("answer_gain"))
    diagnosis.answer_gain = gain_of(whole["answer_gain"]);
  else if (!whole.contains("method") && !diagnosis.ranking.empty())  // documents of before have that gain alone
    diagnosis.answer_gain = diagnosis.ranking.front().gain;
  for (const ordered_json& one : list_of(whole, "missing_force")) diagnosis.missing_force.push_back(curve_of(one));
  if (whole.contains("unexplained")) diagnosis.unexplained = unexplained_of(whole["unexplained"]);
  for (const ordered_json& one : list_of(whole, "formulas")) diagnosis.formulas.push_back(formula_of(one));
  for (const ordered_json& one : list_of(whole, "residual_force")) diagnosis.residual_force.push_back(curve_of(one));
  diagnosis.hypotheses = whole["hypotheses"];
  diagnosis.effect_filter = whole.value("effect_filter", std::vector<std::string>{});
  diagnosis.findings = whole["findings"].get<std::vector<std::string>>();
  diagnosis.next_test = whole["next_test"];
  if (whole.contains("next_test_setup") && !whole["next_test_setup"].is_null())
    diagnosis.next_test_setup = setup_of(whole["next_test_setup"]);
  diagnosis.next_test_worth = whole["next_test_worth"];
  for (const ordered_json& one : whole["not_testable"])
    diagnosis.untestable.push_back({one["effect"], one["where"], one["reason"], one.value("failed", false)});
  if (whole.contains("stopped")) diagnosis.stopped = stop_of(whole["stopped"]);
  diagnosis.seconds = figure(whole["seconds"]);
  return diagnosis;
}

}  // namespace lacuna
