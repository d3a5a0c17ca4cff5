#include "evaluation/model/model_definition.h"

#include "evaluation/model/component_choice.h"
#include "evaluation/model/effect_placement.h"
#include "evaluation/model/recorded_setups.h"
#include "evaluation/model/robot_values.h"
#include "evaluation/model/target_check.h"
#include "foundation/address.h"
#include "simulation/robot_problems.h"

namespace lacuna {
namespace {

/// The robot of its plugin; one without bodies where the plugin fails.
RobotSpec build_robot(const SystemSource& source, const PluginCatalog& catalog, Complaints& complaints) {
  const Chosen<RobotDefinition> plugin =
      choose<RobotDefinition>(catalog, {source.section.robot, source.section.parameters},
                              {source.key + ".robot", source.key + ".parameters"}, complaints);
  if (!plugin.component) return {};
  try {
    const RobotRequest request{plugin.parameters, source.section.declared ? &*source.section.declared : nullptr};
    RobotSpec robot = guarded_call(plugin.origin, "build", [&] { return plugin->build(request); });
    const std::vector<std::string> problems = robot_problems(robot);
    for (const std::string& problem : problems)
      complaints.add(source.key + ".robot", to_string(plugin.origin) + " makes an invalid robot: " + problem);
    if (problems.empty()) return robot;
  } catch (const Error& error) {
    complaints.add(source.key + ".robot", error);
  }
  return {};
}

/// All but the effects.
ModelDefinition define_system(const SystemSource& source, const EngineSettings& engine, const PluginCatalog& catalog,
                              Complaints& complaints) {
  ModelDefinition definition;
  definition.engine = engine;
  RobotSpec& robot = definition.structure.robot;
  robot = build_robot(source, catalog, complaints);
  if (definition.engine.engine.empty()) definition.engine.engine = engine_for(robot);
  if (robot.bodies.empty()) return definition;
  set_robot_values(robot, source, complaints);
  definition.free = free_robot_values(robot, source, complaints);
  return definition;
}

void name_parameters(ModelDefinition& definition) {
  for (const FreeValue& value : definition.free)
    definition.structure.parameters.push_back(
        {std::string(without_setup(value.address)), value.lower, value.upper, value.setup});
}

}  // namespace

std::vector<double> ModelDefinition::start_values() const {
  std::vector<double> values;
  for (const FreeValue& value : free) values.push_back(value.start);
  return values;
}

ModelDefinition define_model(const Experiment& experiment, const PluginCatalog& catalog) {
  const SystemSource source{experiment.model, "model", "free", true};
  Complaints complaints(experiment);
  ModelDefinition definition = define_system(source, experiment.engine, catalog, complaints);
  if (!definition.structure.robot.bodies.empty()) check_target(definition.structure.robot, experiment, complaints);
  place_effects(definition, source, catalog, complaints);
  complaints.throw_if_any();
  add_setups(definition, experiment.target.recording, complaints);
  complaints.throw_if_any();
  name_parameters(definition);
  return definition;
}

ModelDefinition define_target(const Experiment& experiment, const PluginCatalog& catalog) {
  const SystemSource source{experiment.target.simulated.system, "target", "hidden", false};
  Complaints complaints(experiment);
  EngineSettings engine = experiment.engine;
  if (experiment.target.simulated.substeps > 0) engine.substeps = experiment.target.simulated.substeps;
  ModelDefinition definition = define_system(source, engine, catalog, complaints);
  RobotSpec& robot = definition.structure.robot;
  if (definition.engine.engine == "articulated") definition.engine.engine = engine_for(robot);
  if (!robot.bodies.empty()) set_sensor_noise(robot, experiment.target.simulated.noise, complaints);
  place_effects(definition, source, catalog, complaints);
  complaints.throw_if_any();
  name_parameters(definition);
  return definition;
}

}  // namespace lacuna
