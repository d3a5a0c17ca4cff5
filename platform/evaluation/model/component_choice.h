#pragma once

#include "evaluation/model/complaints.h"
#include "loading/plugin_catalog.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A component with a value for each of its declared parameters, in their order, SI. The catalog owns the component.
template <class Interface>
struct Chosen {
  const Interface* component = nullptr;
  std::vector<double> parameters;
  ComponentOrigin origin;  ///< for `guarded_call`

  const Interface* operator->() const { return component; }
};

/// The keys of the choice in a file: "estimation.search" and "estimation.parameters".
struct ChoiceKeys {
  std::string name;
  std::string parameters;
};

/// The given values, and the defaults of the others. Complains below `key` about names that are not declared, values
/// outside their declared bounds and units of another dimension; nothing then.
std::optional<std::vector<double>> parameter_values(const ParameterDeclarations& declarations,
                                                    const std::map<std::string, double>& given,
                                                    const ComponentOrigin& origin, const std::string& key,
                                                    Complaints& complaints);

/// The component that the file names; without one (`component` null) after a complaint.
template <class Interface>
Chosen<Interface> choose(const PluginCatalog& catalog, const ComponentChoice& choice, const ChoiceKeys& keys,
                         Complaints& complaints) {
  Chosen<Interface> chosen;
  chosen.origin = catalog.origin<Interface>(choice.name);
  try {
    const Interface& component = catalog.get<Interface>(choice.name);
    const ParameterDeclarations declarations =
        guarded_call(chosen.origin, "parameters", [&] { return component.parameters(); });
    const auto values = parameter_values(declarations, choice.parameters, chosen.origin, keys.parameters, complaints);
    if (!values) return chosen;
    chosen.parameters = *values;
    chosen.component = &component;
  } catch (const Error& error) {
    complaints.add(keys.name, error);
  }
  return chosen;
}

}  // namespace lacuna
