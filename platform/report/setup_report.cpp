#include "report/setup_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace lacuna {

std::string setups_text(const std::vector<KnownSetup>& setups) {
  std::string text;
  if (!any_is_set(setups)) return text;
  for (const KnownSetup& setup : setups)
    text += fmt::format("{}: {} · {}\n", setup.name().empty() ? "no setup" : "setup " + setup.name(),
                        settings_text(setup), fmt::join(setup.recordings, ", "));
  return text;
}

nlohmann::ordered_json setup_json(const KnownSetup& setup) {
  nlohmann::ordered_json set = nlohmann::ordered_json::object();
  for (const KnownSetup::Setting& one : setup.settings) set[one.address] = {{"value", one.value}, {"unit", one.unit}};
  return {{"name", setup.name()}, {"set", set}, {"own", setup.own}};
}

nlohmann::ordered_json setups_json(const std::vector<KnownSetup>& setups) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  if (!any_is_set(setups)) return list;
  for (const KnownSetup& setup : setups) {
    list.push_back(setup_json(setup));
    list.back()["recordings"] = setup.recordings;
  }
  return list;
}

KnownSetup setup_of(const nlohmann::ordered_json& json) {
  KnownSetup setup{.names = {json["name"].get<std::string>()}};
  for (const auto& [address, set] : json["set"].items())
    setup.settings.push_back({address, set["value"].get<double>(), set["unit"].get<std::string>()});
  setup.own = json["own"].get<std::vector<std::string>>();
  return setup;
}

}  // namespace lacuna
