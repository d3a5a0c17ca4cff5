#include "documents/diagnosis_json.h"

#include "documents/setup_json.h"

#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

ordered_json by_name(const std::vector<FoundParameter>& parameters) {
  ordered_json object = ordered_json::object();
  for (const FoundParameter& one : parameters) {
    ordered_json& value = object[one.name];
    value = {{"value", one.value}, {"ci95", {one.lower_95, one.upper_95}}, {"unit", one.unit}};
    if (one.stated) value["stated"] = *one.stated;
    if (one.at_bound) value["at_bound"] = true;
  }
  return object;
}

ordered_json document(const FoundEffect& effect) {
  ordered_json result = {
      {"effect", effect.effect}, {"where", effect.where}, {"parameters", by_name(effect.parameters)}};
  for (const HeldParameter& one : effect.held) result["held"][one.name] = {{"value", one.value}, {"unit", one.unit}};
  return result;
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

/// Names of the errors of held-out readings and of the ratio to the floor; the ratio is that of the fitted data.
constexpr const char* kHeldOut = "held_out_rmse";
constexpr const char* kRatio = "fitted_ratio_to_floor";

ordered_json document(const RankedModel& model) {
  ordered_json effects = ordered_json::array();
  for (const FoundEffect& effect : model.effects) effects.push_back(document(effect));
  return {{"effects", effects},
          {"class", model.look_alikes},
          {"noise_floor", by_channel(model.errors, &ChannelError::floor)},
          {"fit_rmse", by_channel(model.errors, &ChannelError::fit)},
          {kHeldOut, by_channel(model.errors, &ChannelError::held_out)},
          {kRatio, model.times_floor},
          {"segment_s", model.segment},
          {"gain", model.gain.value},
          {"gain_ci95", {model.gain.lower_95, model.gain.upper_95}},
          {"gain_standard_error", model.gain.standard_error}};
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
  if (!curve.by_answer.empty()) document["by_answer"] = curve.by_answer;
  return document;
}

ordered_json document(const UnexplainedForce& force) {
  return {
      {"joint", force.joint}, {"depends_on", force.depends_on}, {"share", force.share}, {"gain", document(force.gain)}};
}

ordered_json document(const Untestable& one) {
  return {{"effect", one.effect}, {"where", one.where}, {"reason", one.reason}, {"failed", one.failed}};
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

template <class Value>
ordered_json list(const std::vector<Value>& values) {
  ordered_json all = ordered_json::array();
  for (const Value& value : values) all.push_back(document(value));
  return all;
}

ordered_json base(const Diagnosis& diagnosis) {
  return {{"fit_rmse", by_channel(diagnosis.base, &ChannelError::fit)},
          {kHeldOut, by_channel(diagnosis.base, &ChannelError::held_out)},
          {kRatio, diagnosis.base_times_floor},
          {"segment_s", diagnosis.base_segment}};
}

/// Results of a search; a key that is absent was not computed.
void add_search(const Diagnosis& diagnosis, ordered_json& whole) {
  whole["base"] = base(diagnosis);
  whole["horizons"] = list(diagnosis.horizons);
  if (diagnosis.p_by_chance) whole["p_by_chance"] = *diagnosis.p_by_chance;
  if (diagnosis.answer_gain) whole["answer_gain"] = document(*diagnosis.answer_gain);
  if (!diagnosis.missing_force.empty()) whole["missing_force"] = list(diagnosis.missing_force);
  if (diagnosis.unexplained) whole["unexplained"] = document(*diagnosis.unexplained);
  if (!diagnosis.formulas.empty()) whole["formulas"] = list(diagnosis.formulas);
  if (!diagnosis.residual_force.empty()) whole["residual_force"] = list(diagnosis.residual_force);
}

}  // namespace

std::string diagnosis_json(const Diagnosis& diagnosis) {
  ordered_json whole = {{"verdict", to_string(diagnosis.verdict)}};
  if (diagnosis.method) whole["method"] = to_string(*diagnosis.method);
  whole.update(
      {{"probability", diagnosis.probability},
       {"calibrated", diagnosis.calibrated},
       {"evidence", diagnosis.evidence},
       {"noise_floor", by_channel(diagnosis.base, &ChannelError::floor)},
       {"units", units(diagnosis.base)},
       {"ranking", list(diagnosis.ranking)},
       {"values", by_name(diagnosis.values)},
       {"hypotheses", diagnosis.hypotheses},
       {"effect_filter", diagnosis.effect_filter},
       {"findings", diagnosis.findings},
       {"next_test", diagnosis.next_test},
       {"next_test_setup", diagnosis.next_test_setup ? setup_json(*diagnosis.next_test_setup) : ordered_json(nullptr)},
       {"next_test_worth", diagnosis.next_test_worth},
       {"not_testable", list(diagnosis.untestable)},
       {"seconds", diagnosis.seconds}});
  if (diagnosis.method) add_search(diagnosis, whole);
  if (const std::optional<StoppedSearch>& stop = diagnosis.stopped)
    whole["stopped"] = {{"during", stop->during}, {"not_examined", stop->not_examined}, {"next", stop->next}};
  return whole.dump(2) + "\n";
}

}  // namespace lacuna
