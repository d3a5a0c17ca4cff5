#include "runs/read_results.h"

#include "runs/case_failure.h"

#include <nlohmann/json.hpp>

#include <string>

namespace hidden_effects {
namespace {

using nlohmann::ordered_json;

double number(const ordered_json& object) { return object.is_null() ? kUnknown : object.get<double>(); }

/// A key that is absent was not asked.
double asked(const ordered_json& object, const char* name) {
  return object.contains(name) ? number(object.at(name)) : kUnknown;
}

/// By likelihood of what was left out, by horizon of what was fitted.
double ratio_to_floor(const ordered_json& object) {
  return asked(object, object.contains("ratio_to_floor") ? "ratio_to_floor" : "fitted_ratio_to_floor");
}

std::string place_of(const std::string& where) { return where.empty() ? "world" : where; }

IntervalRecord interval_of(const std::string& name, const ordered_json& object) {
  return {name, number(object.at("value")), number(object.at("ci95").at(0)), number(object.at("ci95").at(1))};
}

RankedEffectRecord effect_of(const ordered_json& object) {
  RankedEffectRecord effect{{object.at("effect"), place_of(object.at("where"))}, {}};
  for (const auto& [name, one] : object.at("parameters").items()) effect.parameters.push_back(interval_of(name, one));
  return effect;
}

/// "name @ where"
EffectAt look_alike_of(const std::string& text) {
  const std::size_t at = text.find(" @ ");
  if (at == std::string::npos) return {text, "world"};
  return {text.substr(0, at), place_of(text.substr(at + 3))};
}

RankedModelRecord model_of(const ordered_json& object) {
  RankedModelRecord model{asked(object, "probability"), number(object.at("gain")), ratio_to_floor(object), {}, {}};
  for (const ordered_json& effect : object.at("effects")) model.effects.push_back(effect_of(effect));
  for (const ordered_json& name : object.at("class")) model.look_alikes.push_back(look_alike_of(name));
  return model;
}

ordered_json parsed(const std::string& text, const char* what) {
  try {
    return ordered_json::parse(text);
  } catch (const ordered_json::exception& error) {
    throw CaseFailure(std::string("the JSON of ") + what + " cannot be read: " + error.what());
  }
}

/// `read(document)`, with its faults told as such.
template <class Read>
auto reading(const std::string& text, const char* what, const Read& read) {
  const ordered_json document = parsed(text, what);
  try {
    return read(document);
  } catch (const ordered_json::exception& error) {
    throw CaseFailure(std::string("the JSON of ") + what + " is not as expected: " + error.what());
  }
}

}  // namespace

DiagnosisRecord read_diagnosis(const std::string& json) {
  return reading(json, "lacuna diagnose", [&](const ordered_json& document) {
    DiagnosisRecord record;
    record.verdict = document.at("verdict");
    record.probability = number(document.at("probability"));
    record.p_by_chance = asked(document, "p_by_chance");
    record.times_floor = ratio_to_floor(document.value("base", ordered_json::object()));
    record.seconds = number(document.at("seconds"));
    record.json = json;
    record.next_test = document.value("next_test", "");
    for (const ordered_json& model : document.at("ranking")) record.ranking.push_back(model_of(model));
    for (const auto& [name, one] : document.at("values").items()) record.values.push_back(interval_of(name, one));
    return record;
  });
}

ReadComparison read_comparison(const std::string& json) {
  return reading(json, "lacuna compare", [](const ordered_json& document) {
    ReadComparison comparison;
    for (const ordered_json& score : document.at("pooled")) {
      if (!score.at("held_out").get<bool>()) continue;
      const bool whole = score.at("failed_trials").get<int>() == 0;
      comparison.held_out.push_back({score.at("channel"), whole ? number(score.at("rmse")) : kUnknown});
    }
    return comparison;
  });
}

std::vector<std::string> read_effects(const std::string& json) {
  return reading(json, "lacuna plugins list", [](const ordered_json& document) {
    std::vector<std::string> names;
    for (const ordered_json& component : document.at("components"))
      if (component.at("kind") == "effect") names.push_back(component.at("name"));
    return names;
  });
}

}  // namespace hidden_effects
