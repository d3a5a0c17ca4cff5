#include "documents/setup_json.h"

#include <nlohmann/json.hpp>

namespace lacuna {

nlohmann::ordered_json setup_json(const KnownSetup& setup) {
  nlohmann::ordered_json set = nlohmann::ordered_json::object();
  for (const KnownSetup::Setting& one : setup.settings) set[one.address] = {{"value", one.value}, {"unit", one.unit}};
  return {{"name", setup.name()},
          {"names", setup.names},
          {"set", set},
          {"own", setup.own},
          {"recordings", setup.recordings}};
}

nlohmann::ordered_json setups_json(const std::vector<KnownSetup>& setups) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  if (!any_is_set(setups)) return list;
  for (const KnownSetup& setup : setups) list.push_back(setup_json(setup));
  return list;
}

KnownSetup setup_of(const nlohmann::ordered_json& json) {
  KnownSetup setup;
  setup.names = json.value("names", std::vector<std::string>{json["name"].get<std::string>()});
  for (const auto& [address, set] : json["set"].items())
    setup.settings.push_back({address, set["value"].get<double>(), set["unit"].get<std::string>()});
  setup.own = json["own"].get<std::vector<std::string>>();
  setup.recordings = json.value("recordings", std::vector<std::string>{});
  return setup;
}

}  // namespace lacuna
