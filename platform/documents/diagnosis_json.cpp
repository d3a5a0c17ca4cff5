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

ordered_json document(const RankedModel& model) {
  ordered_json effects = ordered_json::array();
  for (const FoundEffect& effect : model.effects) effects.push_back(document(effect));
  return {{"effects", effects},
          {"class", model.look_alikes},
          {"noise_floor", by_channel(model.errors, &ChannelError::floor)},
          {"fit_rmse", by_channel(model.errors, &ChannelError::fit)},
          {"cv_rmse", by_channel(model.errors, &ChannelError::held_out)},
          {"ratio_to_floor", model.times_floor},
          {"segment_s", model.segment},
          {"gain", model.gain.value},
          {"gain_ci95", {model.gain.lower_95, model.gain.upper_95}},
          {"gain_standard_error", model.gain.standard_error},
          {"probability", model.probability}};
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
  return {{"effect", one.effect}, {"where", one.where}, {"reason", one.reason}};
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

}  // namespace

std::string diagnosis_json(const Diagnosis& diagnosis) {
  ordered_json whole = {
      {"verdict", to_string(diagnosis.verdict)},
      {"probability", diagnosis.probability},
      {"calibrated", diagnosis.calibrated},
      {"form_only", diagnosis.form_only},
      {"at_threshold", list(diagnosis.at_threshold)},
      {"evidence", diagnosis.evidence},
      {"horizons", list(diagnosis.horizons)},
      {"noise_floor", by_channel(diagnosis.base, &ChannelError::floor)},
      {"units", units(diagnosis.base)},
      {"random_forces", list(diagnosis.forces)},
      {"base",
       {{"fit_rmse", by_channel(diagnosis.base, &ChannelError::fit)},
        {"cv_rmse", by_channel(diagnosis.base, &ChannelError::held_out)},
        {"ratio_to_floor", diagnosis.base_times_floor},
        {"segment_s", diagnosis.base_segment}}},
      {"ranking", list(diagnosis.ranking)},
      {"values", by_name(diagnosis.values)},
      {"segment_lengths", list(diagnosis.lengths)},
      {"p_by_chance", diagnosis.p_by_chance},
      {"chance_95", diagnosis.chance_95},
      {"free_force", {{"p", diagnosis.free_force_p}, {"gain", document(diagnosis.free_force_gain)}}},
      {"answer_gain", document(diagnosis.answer_gain)},
      {"formulas", list(diagnosis.formulas)},
      {"formulas_of_rest", diagnosis.formulas_of_rest},
      {"residual_force", list(diagnosis.residual_force)},
      {"hypotheses", diagnosis.hypotheses},
      {"findings", diagnosis.findings},
      {"next_test", diagnosis.next_test},
      {"next_test_setup", diagnosis.next_test_setup ? setup_json(*diagnosis.next_test_setup) : ordered_json(nullptr)},
      {"next_test_worth", diagnosis.next_test_worth},
      {"not_testable", list(diagnosis.untestable)},
      {"seconds", diagnosis.seconds}};
  if (const std::optional<StoppedSearch>& stop = diagnosis.stopped)
    whole["stopped"] = {{"during", stop->during}, {"not_examined", stop->not_examined}, {"next", stop->next}};
  return whole.dump(2) + "\n";
}

}  // namespace lacuna
