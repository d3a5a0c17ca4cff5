#include "simulation/shared/effect_schedule.h"

#include "foundation/text/problem.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace lacuna::simulation {
namespace {

constexpr int kLargestState = 1 << 24;  // of one effect, doubles

std::size_t elements_of_kind(const RobotSpec& robot, ElementKind kind) {
  switch (kind) {
    case ElementKind::joint: return robot.joints.size();
    case ElementKind::body: return robot.bodies.size();
    case ElementKind::actuator: return robot.actuators.size();
    case ElementKind::sensor: return robot.sensors.size();
    case ElementKind::world: return 0;
  }
  return 0;
}

void check_effect(const PlacedEffect& placed, const RobotSpec& robot, ProblemList& problems) {
  const std::string where = "effect \"" + placed.id + "\" (" + placed.name + "): ";
  if (!placed.effect) {
    problems.add({}, where + "it has no component");
    return;
  }
  const std::size_t declared =
      guarded_call(origin_of(placed), "describe", [&] { return placed.effect->describe(); }).parameters.size();
  if (placed.values.size() != declared)
    problems.add({}, where + "it has " + std::to_string(placed.values.size()) + " values for " +
                         std::to_string(declared) + " declared parameters");
  const std::size_t count = elements_of_kind(robot, placed.kind);
  for (const int element : placed.elements)
    if (element < 0 || static_cast<std::size_t>(element) >= count)
      problems.add({}, where + "it is placed on an element that the robot does not have");
  const EffectHooks hooks = guarded_call(origin_of(placed), "stages", [&] { return placed.effect->hooks(); });
  if (hooks.command != CommandStage::none && placed.kind != ElementKind::actuator)
    problems.add({}, where + "it changes commands and must be placed on actuators");
  if (hooks.sensor != SensorStage::none && placed.kind != ElementKind::sensor)
    problems.add({}, where + "it changes sensor readings and must be placed on sensors");
}

void check_ids(const std::vector<PlacedEffect>& effects, ProblemList& problems) {
  for (std::size_t i = 0; i < effects.size(); ++i)
    for (std::size_t j = i + 1; j < effects.size(); ++j)
      if (effects[i].id == effects[j].id)
        problems.add({}, "two effects have the id \"" + effects[i].id + "\"; ids must differ");
}

template <class Stage>
void sort_by_stage(std::vector<EffectSchedule::Call>& calls, Stage&& stage_of) {
  std::stable_sort(calls.begin(), calls.end(), [&](const EffectSchedule::Call& a, const EffectSchedule::Call& b) {
    return stage_of(a.effect) < stage_of(b.effect);
  });
}

}  // namespace

std::vector<PlacedEffect> canonical(std::vector<PlacedEffect> effects) {
  std::stable_sort(effects.begin(), effects.end(), [](const PlacedEffect& a, const PlacedEffect& b) {
    return std::tie(a.name, a.kind, a.elements, a.id) < std::tie(b.name, b.kind, b.elements, b.id);
  });
  return effects;
}

EffectSchedule::EffectSchedule(const std::vector<PlacedEffect>& effects, const RobotSpec& robot, double step)
    : effects_(effects), step_(step), commands_(robot.actuators.size()), senses_(robot.sensors.size()) {
  ProblemList problems;
  for (const PlacedEffect& placed : effects) check_effect(placed, robot, problems);
  check_ids(effects, problems);
  problems.throw_if_any();
  for (const PlacedEffect& placed : effects) on_page_.push_back(lacuna::on_page(origin_of(placed)));
  for (std::size_t i = 0; i < effects.size(); ++i) schedule(i);
  for (auto& calls : commands_)
    sort_by_stage(calls, [&](std::size_t effect) { return effects_[effect].effect->hooks().command; });
  for (auto& calls : senses_)
    sort_by_stage(calls, [&](std::size_t effect) { return effects_[effect].effect->hooks().sensor; });
  state_offsets_.assign(effects.size() + 1, 0);
}

void EffectSchedule::schedule(std::size_t effect) {
  const PlacedEffect& placed = effects_[effect];
  const EffectHooks hooks = placed.effect->hooks();
  if (hooks.amends_robot) amending_.push_back(effect);
  if (hooks.add_loads) loading_.push_back(effect);
  if (hooks.advance) advancing_.push_back(effect);
  for (std::size_t which = 0; which < placed.elements.size(); ++which) {
    const auto element = static_cast<std::size_t>(placed.elements[which]);
    const Call call{effect, static_cast<int>(which)};
    if (hooks.command != CommandStage::none) commands_[element].push_back(call);
    if (hooks.sensor != SensorStage::none) senses_[element].push_back(call);
  }
  const bool of_bodies = placed.kind == ElementKind::body || placed.kind == ElementKind::world;
  looks_at_bodies_ = looks_at_bodies_ || (of_bodies && (hooks.add_loads || hooks.advance));
  any_sense_ = any_sense_ || hooks.sensor != SensorStage::none;
}

void EffectSchedule::size_states(const std::vector<std::vector<double>>& largest_values) {
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    const int size = guarded_call(origin_of(effects_[i]), "state_size",
                                  [&] { return effects_[i].effect->state_size(context(i, largest_values[i])); });
    if (size < 0 || size > kLargestState)
      throw Error(to_string(origin_of(effects_[i])) + ": it asks for a state of " + std::to_string(size) +
                  " numbers; allowed are 0 to " + std::to_string(kLargestState) +
                  "; repair the plugin, or take the effect out of the model");
    state_offsets_[i + 1] = state_offsets_[i] + static_cast<std::size_t>(size);
  }
}

EffectContext EffectSchedule::context(std::size_t effect, std::span<const double> values) const {
  return {.parameters = values, .elements = effects_[effect].elements, .kind = effects_[effect].kind, .step = step_};
}

std::span<double> EffectSchedule::state_of(std::size_t effect, std::span<double> states) const {
  return states.subspan(state_offsets_[effect], state_offsets_[effect + 1] - state_offsets_[effect]);
}

}  // namespace lacuna::simulation
