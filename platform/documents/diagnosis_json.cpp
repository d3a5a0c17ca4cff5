#include "documents/diagnosis_json.h"

#include "documents/setup_json.h"

#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

ordered_json by_name(const std::vector<FoundParameter>& parameters) {
  ordered_json object = ordered_json::object();
  for (const FoundParameter& one : parameters)
    object[one.name] = {{"value", one.value}, {"ci95", {one.lower_95, one.upper_95}}, {"unit", one.unit}};
  return object;
}

ordered_json document(const FoundEffect& effect) {
  return {{"effect", effect.effect}, {"where", effect.where}, {"parameters", by_name(effect.parameters)}};
}

ordered_json by_channel(const std::vector<ChannelError>& errors, double ChannelError::*figure) {
  ordered_json object = ordered_json::object();
  for (const ChannelError& error : errors) object[error.channel] = error.*figure;
  return object;
}

ordered_json units(const std::vector<ChannelError>& errors) {
  ordered_json object = ordered_json::object();
  for (const ChannelError& error : errors) object[error.channel] = error.unit;
  return object;
}

/// How errors are named: by likelihood those of what was left out are told beside the fitted ones, by horizon those of
/// held-out recordings, and the ratio to the floor is of what was fitted.
struct ErrorNames {
  const char *other_rmse, *ratio;
};

ErrorNames names_of(const Diagnosis& diagnosis) {
  if (method_of(diagnosis) == DiagnosisMethod::horizon) return {"held_out_rmse", "fitted_ratio_to_floor"};
  return {"cv_rmse", "ratio_to_floor"};
}

ordered_json document(const RankedModel& model, const ErrorNames& names) {
  ordered_json effects = ordered_json::array();
  for (const FoundEffect& effect : model.effects) effects.push_back(document(effect));
  ordered_json json = {{"effects", effects},
                       {"class", model.look_alikes},
                       {"noise_floor", by_channel(model.errors, &ChannelError::floor)},
                       {"fit_rmse", by_channel(model.errors, &ChannelError::fit)},
                       {names.other_rmse, by_channel(model.errors, &ChannelError::held_out)},
                       {names.ratio, model.times_floor},
                       {"segment_s", model.segment},
                       {"gain", model.gain.value},
                       {"gain_ci95", {model.gain.lower_95, model.gain.upper_95}},
                       {"gain_standard_error", model.gain.standard_error}};
  if (model.probability) json["probability"] = *model.probability;
  return json;
}

ordered_json document(const Gain& gain) {
  return {{"value", gain.value}, {"standard_error", gain.standard_error}, {"ci95", {gain.lower_95, gain.upper_95}}};
}

ordered_json document(const ForceFormula& formula) {
  ordered_json terms = ordered_json::array();
  for (const ForceFormula::Term& term : formula.terms)
    terms.push_back({{"text", term.text},
                     {"coefficient", term.coefficient},
                     {"standard_error", term.standard_error},
                     {"unit", term.unit}});
  return {{"joint", formula.joint},
          {"text", formula.text()},
          {"unit", formula.unit},
          {"terms", terms},
          {"gain", document(formula.gain)}};
}

ordered_json document(const ForceCurve& curve) {
  ordered_json document = {{"joint", curve.joint},
                           {"of", curve.of},
                           {"unit", curve.unit},
                           {"force_unit", curve.force_unit},
                           {"at", curve.at},
                           {"force", curve.force},
                           {"standard_error", curve.standard_error}};
  if (curve.position) document["position"] = *curve.position;
  return document;
}

ordered_json document(const Untestable& one) {
  return {{"effect", one.effect}, {"where", one.where}, {"reason", one.reason}, {"failed", one.failed}};
}

ordered_json document(const AtThreshold& near) {
  return {{"figure", near.figure},       {"unit", to_string(near.unit)},   {"value", near.value},
          {"threshold", near.threshold}, {"range", {near.low, near.high}}, {"other_verdict", to_string(near.other)}};
}

ordered_json document(const RandomForce& force) {
  return {{"joint", force.joint},
          {"deviation", force.deviation},
          {"unit", force.unit},
          {"duration_s", force.duration},
          {"slow", force.slow}};
}

ordered_json document(const HorizonError& one) {
  return {{"horizon_s", one.horizon},
          {"channel", one.channel},
          {"unit", one.unit},
          {"floor", one.floor},
          {"base", one.base},
          {"answer", one.answer},
          {"base_held_out", one.base_held_out},
          {"answer_held_out", one.answer_held_out}};
}

ordered_json document(const EffectsAtLength& at) {
  ordered_json effects = ordered_json::array();
  for (const FoundEffect& effect : at.effects) effects.push_back(document(effect));
  return {{"segment_s", at.segment}, {"effects", effects}, {"against", at.against}};
}

template <class Value>
ordered_json list(const std::vector<Value>& values) {
  ordered_json all = ordered_json::array();
  for (const Value& value : values) all.push_back(document(value));
  return all;
}

ordered_json ranking(const Diagnosis& diagnosis) {
  ordered_json all = ordered_json::array();
  for (const RankedModel& model : diagnosis.ranking) all.push_back(document(model, names_of(diagnosis)));
  return all;
}

/// What likelihoods alone tell; a key that is not there was not asked.
void add_likelihoods(const Diagnosis& diagnosis, ordered_json& whole) {
  const bool asked = method_of(diagnosis) == DiagnosisMethod::likelihood;
  const auto add = [&](const char* name, const auto& values) {
    if (asked || !values.empty()) whole[name] = list(values);
  };
  add("at_threshold", diagnosis.at_threshold);
  add("random_forces", diagnosis.forces);
  add("segment_lengths", diagnosis.lengths);
  if (asked || diagnosis.form_only) whole["form_only"] = diagnosis.form_only;
  if (diagnosis.p_by_chance) whole["p_by_chance"] = *diagnosis.p_by_chance;
  if (diagnosis.chance_95) whole["chance_95"] = *diagnosis.chance_95;
  if (diagnosis.free_force_p) whole["free_force"]["p"] = *diagnosis.free_force_p;
  if (diagnosis.free_force_gain) whole["free_force"]["gain"] = document(*diagnosis.free_force_gain);
  add("formulas", diagnosis.formulas);
  if (asked || diagnosis.formulas_of_rest) whole["formulas_of_rest"] = diagnosis.formulas_of_rest;
  add("residual_force", diagnosis.residual_force);
}

ordered_json base(const Diagnosis& diagnosis) {
  const ErrorNames names = names_of(diagnosis);
  return {{"fit_rmse", by_channel(diagnosis.base, &ChannelError::fit)},
          {names.other_rmse, by_channel(diagnosis.base, &ChannelError::held_out)},
          {names.ratio, diagnosis.base_times_floor},
          {"segment_s", diagnosis.base_segment}};
}

}  // namespace

std::string diagnosis_json(const Diagnosis& diagnosis) {
  const std::optional<DiagnosisMethod> method = method_of(diagnosis);
  ordered_json whole = {{"verdict", to_string(diagnosis.verdict)}};
  if (method) whole["method"] = to_string(*method);
  whole.update(
      {{"probability", diagnosis.probability},
       {"calibrated", diagnosis.calibrated},
       {"evidence", diagnosis.evidence},
       {"noise_floor", by_channel(diagnosis.base, &ChannelError::floor)},
       {"units", units(diagnosis.base)},
       {"ranking", ranking(diagnosis)},
       {"values", by_name(diagnosis.values)},
       {"hypotheses", diagnosis.hypotheses},
       {"findings", diagnosis.findings},
       {"next_test", diagnosis.next_test},
       {"next_test_setup", diagnosis.next_test_setup ? setup_json(*diagnosis.next_test_setup) : ordered_json(nullptr)},
       {"next_test_worth", diagnosis.next_test_worth},
       {"not_testable", list(diagnosis.untestable)},
       {"seconds", diagnosis.seconds}});
  if (method) whole["base"] = base(diagnosis);
  if (method == DiagnosisMethod::horizon) whole["horizons"] = list(diagnosis.horizons);
  if (diagnosis.answer_gain) whole["answer_gain"] = document(*diagnosis.answer_gain);
  add_likelihoods(diagnosis, whole);
  if (const std::optional<StoppedSearch>& stop = diagnosis.stopped)
    whole["stopped"] = {{"during", stop->during}, {"not_examined", stop->not_examined}, {"next", stop->next}};
  return whole.dump(2) + "\n";
}

}  // namespace lacuna
