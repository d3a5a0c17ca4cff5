#include "documents/search_state_json.h"

#include "documents/diagnosis_json.h"
#include "foundation/json_depth.h"

#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

constexpr int kFormat = 5;  ///< to be counted up when the state, or the search that follows from it, changes

ordered_json entries_json(const std::vector<EffectEntry>& entries) {
  ordered_json all = ordered_json::array();
  for (const EffectEntry& one : entries)
    all.push_back({{"id", one.id},
                   {"effect", one.effect},
                   {"where", one.where},
                   {"start", one.start},
                   {"fixed", one.fixed},
                   {"range", one.range}});
  return all;
}

std::vector<EffectEntry> read_entries(const ordered_json& json) {
  std::vector<EffectEntry> entries;
  for (const ordered_json& one : json)
    entries.push_back({one.at("id"), one.at("effect"), one.at("where").get<std::vector<std::string>>(),
                       one.at("start").get<std::map<std::string, double>>(),
                       one.at("fixed").get<std::vector<std::string>>(),
                       one.at("range").get<std::map<std::string, std::pair<double, double>>>()});
  return entries;
}

ordered_json gain_json(const Gain& gain) { return {gain.value, gain.standard_error, gain.lower_95, gain.upper_95}; }

Gain read_gain(const ordered_json& json) { return {json.at(0), json.at(1), json.at(2), json.at(3)}; }

ordered_json step_json(const SearchStep& step) {
  ordered_json rivals = ordered_json::array();
  for (const KeptRival& one : step.rivals)
    rivals.push_back({{"entry", entries_json({one.entry})}, {"values", one.values}, {"gain", gain_json(one.gain)}});
  return {{"added", entries_json(step.added)}, {"rivals", rivals}, {"chosen", step.chosen}};
}

SearchStep read_step(const ordered_json& json) {
  SearchStep step{read_entries(json.at("added")), {}, json.at("chosen")};
  for (const ordered_json& one : json.at("rivals"))
    step.rivals.push_back({read_entries(one.at("entry")).front(), one.at("values").get<std::vector<double>>(),
                           read_gain(one.at("gain"))});
  return step;
}

SearchState read_state(const ordered_json& whole) {
  SearchState state;
  state.added = read_entries(whole.at("added"));
  state.values = whole.at("values").get<std::vector<double>>();
  if (!whole.at("last").is_null()) state.last = read_step(whole.at("last"));
  if (!whole.at("first").is_null()) state.first = read_step(whole.at("first"));
  state.first_ranking = read_diagnosis(whole.at("first_answer").dump()).ranking;
  state.most_effects = whole.at("most_effects");
  state.tried = whole.at("tried").get<std::set<EffectNames>>();
  for (const ordered_json& one : whole.at("gains"))
    state.gains[one.at("effects").get<EffectNames>()] = read_gain(one.at("gain"));
  for (const ordered_json& one : whole.at("enough"))
    state.enough[one.at("effects").get<EffectNames>()] = one.at("finding");
  state.base_values = whole.at("base_values").get<std::vector<double>>();
  state.law_leads = whole.at("law_leads");
  state.so_far = read_diagnosis(whole.at("so_far").dump());
  return state;
}

}  // namespace

std::string search_state_json(const SearchState& state) {
  ordered_json gains = ordered_json::array();
  for (const auto& [names, gain] : state.gains) gains.push_back({{"effects", names}, {"gain", gain_json(gain)}});
  ordered_json enough = ordered_json::array();
  for (const auto& [names, finding] : state.enough) enough.push_back({{"effects", names}, {"finding", finding}});
  Diagnosis first_answer = state.so_far;
  first_answer.ranking = state.first_ranking;
  const ordered_json whole = {{"format", kFormat},
                              {"added", entries_json(state.added)},
                              {"values", state.values},
                              {"last", state.last ? step_json(*state.last) : ordered_json()},
                              {"first", state.first ? step_json(*state.first) : ordered_json()},
                              {"first_answer", ordered_json::parse(diagnosis_json(first_answer))},
                              {"most_effects", state.most_effects},
                              {"tried", state.tried},
                              {"gains", gains},
                              {"enough", enough},
                              {"base_values", state.base_values},
                              {"law_leads", state.law_leads},
                              {"so_far", ordered_json::parse(diagnosis_json(state.so_far))}};
  return whole.dump();
}

std::optional<SearchState> read_search_state(const std::string& document) {
  if (nests_too_deep(document)) return std::nullopt;
  try {
    const ordered_json whole = ordered_json::parse(document);
    if (whole.value("format", 0) == kFormat) return read_state(whole);
  } catch (const nlohmann::json::exception&) {  // a figure that JSON does not have, such as NaN: begin anew
  }
  return std::nullopt;
}

}  // namespace lacuna
