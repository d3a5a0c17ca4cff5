#include "plugin_checks/check_result.h"

#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace lacuna {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kOutcomes = {"passed", "failed", "not applicable"};

const char* word_of(CheckOutcome outcome) { return kOutcomes[static_cast<std::size_t>(outcome)]; }

CheckOutcome outcome_of(std::string_view word) {
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    if (word == kOutcomes[i]) return static_cast<CheckOutcome>(i);
  throw Error("\"" + std::string(word) + "\" is not an outcome of a check");
}

bool has_not_failed(const CheckResult& result) { return result.outcome != CheckOutcome::failed; }

constexpr std::size_t kIndent = 31;  // of findings

std::string lines_of(const CheckResult& result, const char* before) {
  const bool failed = result.outcome == CheckOutcome::failed;
  std::string word = result.outcome == CheckOutcome::not_applicable ? "-" : failed ? "FAILED" : "passed";
  std::string text = fmt::format("{}{:<{}}{:<8}{}", before, result.check, kIndent - 8 - std::string_view(before).size(),
                                 word, plain_text(result.finding));
  text.erase(text.find_last_not_of(' ') + 1);
  text += "\n";
  if (!result.why.empty()) text += fmt::format("{:{}}why: {}\n", "", kIndent, result.why);
  if (!result.remedy.empty()) text += fmt::format("{:{}}do:  {}\n", "", kIndent, result.remedy);
  return text;
}

}  // namespace

bool ComponentChecks::passed() const { return std::all_of(checks.begin(), checks.end(), has_not_failed); }

bool PluginChecks::passed() const {
  return has_not_failed(handshake) && std::all_of(components.begin(), components.end(),
                                                  [](const ComponentChecks& component) { return component.passed(); });
}

Json json_of(const CheckResult& result) {
  Json json = {{"check", result.check}, {"outcome", word_of(result.outcome)}, {"finding", result.finding}};
  if (!result.why.empty()) json["why"] = result.why;
  if (!result.remedy.empty()) json["do"] = result.remedy;
  for (const CheckResult::Figure& figure : result.figures)
    json["calls"].push_back(
        {{"call", figure.call}, {"allocations", figure.allocations}, {"nanoseconds", figure.nanoseconds}});
  return json;
}

Json json_of(const PluginChecks& checks) {
  Json json = {{"file", checks.file}, {"passed", checks.passed()}, {"handshake", json_of(checks.handshake)}};
  json["components"] = Json::array();
  for (const ComponentChecks& component : checks.components) {
    Json one = {{"kind", component.kind}, {"name", component.name}, {"passed", component.passed()}};
    one["checks"] = Json::array();
    for (const CheckResult& result : component.checks) one["checks"].push_back(json_of(result));
    json["components"].push_back(std::move(one));
  }
  return json;
}

CheckResult check_result_of(const std::string& text) try {
  const Json json = Json::parse(text);
  CheckResult result;
  result.check = json.at("check").get<std::string>();
  result.outcome = outcome_of(json.at("outcome").get<std::string>());
  result.finding = json.at("finding").get<std::string>();
  result.why = json.value("why", "");
  result.remedy = json.value("do", "");
  for (const Json& figure : json.value("calls", Json::array()))
    result.figures.push_back({figure.at("call").get<std::string>(), figure.at("allocations").get<long>(),
                              figure.at("nanoseconds").get<double>()});
  return result;
} catch (const Json::exception& error) {
  throw Error(std::string("the result of a check cannot be read: ") + error.what());
}

std::string text_of(const PluginChecks& checks) {
  std::string text = checks.file + "\n" + lines_of(checks.handshake, "");
  for (const ComponentChecks& component : checks.components) {
    text += component.kind + " " + component.name + "\n";
    for (const CheckResult& result : component.checks) text += lines_of(result, "  ");
  }
  const auto good =
      static_cast<std::size_t>(std::count_if(checks.components.begin(), checks.components.end(),
                                             [](const ComponentChecks& component) { return component.passed(); }));
  if (!checks.components.empty())
    text += fmt::format("{} of {} passed\n", good, counted(checks.components.size(), "component"));
  return text;
}

}  // namespace lacuna
