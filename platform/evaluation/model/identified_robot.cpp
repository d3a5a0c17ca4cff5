#include "evaluation/model/identified_robot.h"

#include "evaluation/model/robot_values.h"
#include "foundation/address.h"
#include "storage/core/canonical_text.h"

#include <lacuna/physical_effect.h>

#include <algorithm>
#include <map>

namespace lacuna {
namespace {

/// Effects with fitted values, in the order in which an engine calls them.
std::vector<PlacedEffect> valued_effects(const ModelDefinition& definition,
                                         const std::map<std::string, double>& fitted) {
  std::vector<PlacedEffect> effects = definition.structure.effects;
  for (PlacedEffect& placed : effects) {
    const ParameterDeclarations declared =
        guarded_call(origin_of(placed), "describe", [&] { return placed.effect->describe(); }).parameters;
    for (std::size_t i = 0; i < declared.size(); ++i)
      if (const auto found = fitted.find(effect_address(placed.id, declared[i].name)); found != fitted.end())
        placed.values[i] = found->second;
  }
  std::stable_sort(effects.begin(), effects.end(), [](const PlacedEffect& a, const PlacedEffect& b) {
    return std::tie(a.name, a.kind, a.elements, a.id) < std::tie(b.name, b.kind, b.elements, b.id);
  });
  return effects;
}

/// A mass scales the inertia, so it is set before moments of inertia that are fitted, too.
void assign_fitted(RobotSpec& robot, const std::map<std::string, double>& fitted) {
  std::vector<AddressedValue> values = addressed_values(robot);
  std::stable_partition(values.begin(), values.end(),
                        [](const AddressedValue& one) { return matches("body.*.mass", one.address); });
  for (const AddressedValue& value : values)
    if (const auto found = fitted.find(value.address); found != fitted.end()) assign_value(robot, value, found->second);
}

void amend(RobotSpec& robot, const PlacedEffect& placed, double step) {
  if (!guarded_call(origin_of(placed), "stages", [&] { return placed.effect->hooks(); }).amends_robot) return;
  guarded_call(origin_of(placed), "amend", [&] {
    placed.effect->amend(robot, {placed.values, placed.elements, placed.kind, step});
  });
}

bool only_amends(const PlacedEffect& placed) {
  const EffectHooks hooks = guarded_call(origin_of(placed), "stages", [&] { return placed.effect->hooks(); });
  return hooks.amends_robot && !hooks.add_loads && !hooks.advance && hooks.command == CommandStage::none &&
         hooks.sensor == SensorStage::none;
}

/// The addresses at which the robots differ; nothing where they differ in other ways, too.
std::optional<std::vector<std::string>> changed_values(RobotSpec before, RobotSpec after) {
  std::vector<AddressedValue> old = addressed_values(before);
  const std::vector<AddressedValue> now = addressed_values(after);
  if (old.size() != now.size()) return std::nullopt;
  std::vector<std::string> changed;
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (old[i].address != now[i].address) return std::nullopt;
    if (*old[i].value == *now[i].value) continue;
    changed.push_back(old[i].address);
    *old[i].value = *now[i].value;
  }
  if (canonical_text(before) != canonical_text(after)) return std::nullopt;
  return changed;
}

std::string called(const PlacedEffect& placed, const EffectEntry& entry) {
  std::string where;
  for (const std::string& one : entry.where) where += (where.empty() ? " @ " : ", ") + one;
  return placed.name + where;
}

EffectEntry held_entry(EffectEntry entry, const PlacedEffect& placed) {
  const ParameterDeclarations declared =
      guarded_call(origin_of(placed), "describe", [&] { return placed.effect->describe(); }).parameters;
  entry.start.clear();
  entry.fixed.clear();
  entry.range.clear();
  entry.optional = false;
  for (std::size_t i = 0; i < declared.size(); ++i) {
    entry.start[declared[i].name] = placed.values[i];
    entry.fixed.push_back(declared[i].name);
  }
  return entry;
}

const EffectEntry& entry_of(const ModelDefinition& definition, const PlacedEffect& placed) {
  return *std::find_if(definition.effects.begin(), definition.effects.end(),
                       [&](const EffectEntry& one) { return one.id == placed.id; });
}

/// The robot as an engine has it, once all of the effects have amended it.
std::string amended_text(RobotSpec robot, const std::vector<PlacedEffect>& effects, double step) {
  for (const PlacedEffect& placed : effects) amend(robot, placed, step);
  return canonical_text(robot);
}

}  // namespace

IdentifiedRobot identified_robot(const ModelDefinition& definition, std::span<const double> values) {
  IdentifiedRobot identified;
  std::map<std::string, double> fitted;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FreeValue& free = definition.free[i];
    if (free.setup.empty())
      fitted[free.address] = values[i];
    else
      identified.of_setups.emplace_back(free.address, values[i]);
  }
  identified.robot = definition.structure.robot;
  assign_fitted(identified.robot, fitted);
  const double step = definition.engine.step;
  const std::vector<PlacedEffect> effects = valued_effects(definition, fitted);
  RobotSpec robot = identified.robot;
  std::vector<PlacedEffect> others;
  std::vector<IdentifiedRobot::Absorbed> absorbed;
  for (const PlacedEffect& placed : effects) {
    RobotSpec amended = robot;
    if (only_amends(placed)) amend(amended, placed, step);
    const auto changed = only_amends(placed) ? changed_values(robot, amended) : std::nullopt;
    if (!changed) {
      others.push_back(placed);
      continue;
    }
    absorbed.push_back({called(placed, entry_of(definition, placed)), *changed});
    robot = std::move(amended);
  }
  const bool is_same = amended_text(robot, others, step) == amended_text(identified.robot, effects, step);
  if (is_same) {
    identified.robot = std::move(robot);
    identified.absorbed = std::move(absorbed);
  }
  for (const PlacedEffect& placed : is_same ? others : effects)
    identified.effects.push_back(held_entry(entry_of(definition, placed), placed));
  return identified;
}

}  // namespace lacuna
