#include "evaluation/model_definition.h"

#include "evaluation/effect_placement.h"
#include "evaluation/robot_values.h"
#include "evaluation/target_check.h"
#include "foundation/unit.h"
#include "simulation/robot_problems.h"

#include <algorithm>
#include <optional>

namespace lacuna {
namespace {

/// The values that the experiment gives to the robot plugin, in the order it declares them; none where
/// one of them is wrong.
std::optional<std::vector<double>> robot_parameters(const Experiment& experiment,
                                                    const ParameterDeclarations& declarations, Complaints& complaints) {
  const std::size_t complaints_before = complaints.count();
  const std::map<std::string, double>& given = experiment.model.parameters;
  std::vector<double> values;
  std::vector<std::string> names;
  for (const ParameterDeclaration& declaration : declarations) {
    names.push_back(declaration.name);
    const auto found = given.find(declaration.name);
    values.push_back(found == given.end() ? declaration.default_value : found->second);
    complaints.check_unit("model.parameters." + declaration.name, declaration.unit);
    if (values.back() >= declaration.lower && values.back() <= declaration.upper) continue;
    complaints.add("model.parameters." + declaration.name,
                   format_quantity(values.back(), declaration.unit) + " is outside the range of the robot \"" +
                       experiment.model.robot + "\", " + format_quantity(declaration.lower, declaration.unit) + " to " +
                       format_quantity(declaration.upper, declaration.unit));
  }
  for (const auto& [name, value] : given)
    if (std::find(names.begin(), names.end(), name) == names.end())
      complaints.add("model.parameters." + name, "the robot \"" + experiment.model.robot + "\" has no parameter \"" +
                                                     name + "\"" + did_you_mean(name, names));
  if (complaints.count() > complaints_before) return std::nullopt;
  return values;
}

/// The robot as its plugin makes it; one without bodies where that fails.
RobotSpec build_robot(const Experiment& experiment, const PluginCatalog& catalog, Complaints& complaints) {
  const ComponentOrigin origin = catalog.origin<RobotDefinition>(experiment.model.robot);
  try {
    const RobotDefinition& plugin = catalog.get<RobotDefinition>(experiment.model.robot);
    const std::optional<std::vector<double>> parameters = robot_parameters(
        experiment, guarded_call(origin, "parameters", [&] { return plugin.parameters(); }), complaints);
    if (!parameters) return {};
    const RobotRequest request{*parameters, experiment.model.declared ? &*experiment.model.declared : nullptr};
    RobotSpec robot = guarded_call(origin, "build", [&] { return plugin.build(request); });
    const std::vector<std::string> problems = robot_problems(robot);
    for (const std::string& problem : problems)
      complaints.add("model.robot", to_string(origin) + " makes a robot that cannot be: " + problem);
    if (problems.empty()) return robot;
  } catch (const Error& error) {
    complaints.add("model.robot", error.what());
  }
  return {};
}

}  // namespace

std::vector<double> ModelDefinition::start_values() const {
  std::vector<double> values;
  for (const FreeValue& value : free) values.push_back(value.start);
  return values;
}

ModelDefinition define_model(const Experiment& experiment, const PluginCatalog& catalog) {
  Complaints complaints(experiment);
  ModelDefinition definition;
  definition.engine = experiment.engine;
  RobotSpec& robot = definition.structure.robot;
  robot = build_robot(experiment, catalog, complaints);
  if (!robot.bodies.empty()) {
    set_robot_values(robot, experiment, complaints);
    definition.free = free_robot_values(robot, experiment, complaints);
    check_target(robot, experiment, complaints);
  }
  place_effects(definition, experiment, catalog, complaints);
  complaints.throw_if_any();
  for (const FreeValue& value : definition.free)
    definition.structure.parameters.push_back({value.address, value.lower, value.upper});
  return definition;
}

}  // namespace lacuna
