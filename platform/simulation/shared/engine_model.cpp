#include "simulation/shared/engine_model.h"

#include "foundation/address.h"
#include "foundation/text/number_text.h"
#include "foundation/plugins/plugin_call.h"
#include "simulation/shared/effect_runner.h"
#include "simulation/shared/engine_workspace.h"
#include "simulation/shared/robot_checks.h"
#include "simulation/shared/run.h"

#include <lacuna/error.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace lacuna::simulation {
namespace {

ModelStructure checked(ModelStructure structure, const EngineSettings& settings) {
  check_settings(settings);
  check_robot(structure.robot);
  structure.effects = canonical(std::move(structure.effects));
  return structure;
}

bool shorter(const Delay& a, const Delay& b) {
  return a.whole != b.whole ? a.whole < b.whole : a.fraction < b.fraction;
}

void keep_larger(std::vector<double>& largest, std::span<const double> values) {
  if (largest.empty()) largest.assign(values.begin(), values.end());
  for (std::size_t i = 0; i < values.size(); ++i) largest[i] = std::max(largest[i], values[i]);
}

void lengthen(Delay& longest, double seconds, const EngineSettings& settings) {
  if (!(seconds >= 0.0 && seconds < kInfinity))
    throw Error("a delay may become " + number_text(seconds) + " s; give its parameter a finite upper bound");
  const Delay delay = make_delay(seconds, settings);
  if (shorter(longest, delay)) longest = delay;
}

}  // namespace

EngineModel::EngineModel(ModelStructure structure, const EngineSettings& settings, MakeMotion make_motion)
    : structure_(checked(std::move(structure), settings)),
      settings_(settings),
      make_motion_(std::move(make_motion)),
      tree_(make_joint_tree(structure_.robot)),
      effects_(structure_.effects, structure_.robot, step()),
      slots_(structure_),
      channels_(sensor_channels(structure_.robot)),
      coordinates_(name_coordinates(structure_.robot)),
      longest_sensor_delays_(structure_.robot.sensors.size()),
      longest_command_delays_(structure_.robot.actuators.size()) {
  size_memory();
  lay_out_state();
}

void EngineModel::size_memory() {
  std::vector<double> lower, upper;
  for (const VariableParameter& parameter : structure_.parameters) {
    lower.push_back(parameter.lower);
    upper.push_back(parameter.upper);
  }
  ModelInstance instance(structure_, slots_);
  std::vector<std::vector<double>> largest(structure_.effects.size());
  for (const ParameterSlots::Slots& slots : slots_.by_setup()) {
    instance.set(upper, slots);
    for (std::size_t i = 0; i < structure_.effects.size(); ++i) keep_larger(largest[i], instance.effect_values(i));
  }
  effects_.size_states(largest);

  EffectRunner runner(effects_, instance);
  for (const ParameterSlots::Slots& slots : slots_.by_setup())
    for (const std::vector<double>* values : {&upper, &lower}) {
      instance.set(*values, slots);
      lengthen_delays(instance, runner);
    }
}

void EngineModel::lengthen_delays(ModelInstance& instance, EffectRunner& runner) {
  try {
    runner.amend(instance.robot());
  } catch (...) {
    throw Error(runner.explain());
  }
  const RobotSpec& robot = instance.robot();
  for (std::size_t i = 0; i < robot.sensors.size(); ++i)
    lengthen(longest_sensor_delays_[i], robot.sensors[i].delay, settings_);
  for (std::size_t i = 0; i < robot.actuators.size(); ++i)
    lengthen(longest_command_delays_[i], robot.actuators[i].delay, settings_);
}

void EngineModel::lay_out_state() {
  const EngineWorkspace example(*this);
  std::size_t offset = 0;
  for (const auto& [name, size] : example.sections()) {
    layout_.push_back({name, offset, size});
    offset += size;
  }
}

bool EngineModel::has_memory() const {
  const auto some = [](const std::vector<Delay>& longest) {
    return std::any_of(longest.begin(), longest.end(), [](const Delay& delay) { return !delay.none(); });
  };
  return effects_.state_size() > 0 || some(longest_sensor_delays_) || some(longest_command_delays_);
}

std::unique_ptr<Workspace> EngineModel::make_workspace() const { return std::make_unique<EngineWorkspace>(*this); }

void EngineModel::simulate(std::span<const double> parameters, const Test& test, const SimulationOptions& options,
                           Workspace& workspace, SimulationResult& result) const {
  auto* own = dynamic_cast<EngineWorkspace*>(&workspace);
  if (!own || &own->model() != this) throw Error("the workspace belongs to another model; use one made by this model");
  const Evaluation evaluation;
  Run(*this, *own, options, result).carry_out(parameters, test);
}

}  // namespace lacuna::simulation
