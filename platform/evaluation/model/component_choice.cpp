#include "evaluation/model/component_choice.h"

#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {

std::optional<std::vector<double>> parameter_values(const ParameterDeclarations& declarations,
                                                    const std::map<std::string, double>& given,
                                                    const ComponentOrigin& origin, const std::string& key,
                                                    Complaints& complaints) {
  const std::size_t complaints_before = complaints.count();
  const std::string who = "the " + origin.kind + " \"" + origin.name + "\"";
  std::vector<double> values;
  std::vector<std::string> names;
  for (const ParameterDeclaration& declaration : declarations) {
    const std::string place = key + "." + declaration.name;
    names.push_back(declaration.name);
    const auto found = given.find(declaration.name);
    values.push_back(found == given.end() ? declaration.default_value : found->second);
    complaints.check_unit(place, declaration.unit);
    if (values.back() >= declaration.lower && values.back() <= declaration.upper) continue;
    complaints.add(place, format_quantity(values.back(), declaration.unit) + " is outside the range of " + who + ", " +
                              format_quantity(declaration.lower, declaration.unit) + " to " +
                              format_quantity(declaration.upper, declaration.unit));
  }
  for (const auto& [name, value] : given)
    if (std::find(names.begin(), names.end(), name) == names.end())
      complaints.add(fmt::format("{}.{}", key, name),
                     fmt::format("{} has no parameter \"{}\"{}", who, name, did_you_mean(name, names)));
  if (complaints.count() > complaints_before) return std::nullopt;
  return values;
}

}  // namespace lacuna
