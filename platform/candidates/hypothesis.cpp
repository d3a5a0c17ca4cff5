#include "candidates/hypothesis.h"

#include "candidates/wrong_value.h"
#include "foundation/address.h"
#include "foundation/processes/guarded_call.h"
#include "foundation/plugins/plugin_fault.h"

#include <lacuna/error.h>
#include <lacuna/physical_effect.h>

#include <algorithm>
#include <optional>
#include <set>

namespace lacuna {
namespace {

constexpr const char* kEveryJoint = "joint.*";
constexpr std::size_t kMostWithOneValue = 3;  ///< joints that share one value of an effect

template <class Spec>
void add_names(const std::vector<Spec>& elements, const std::string& kind, std::vector<std::string>& names) {
  for (const Spec& element : elements) names.push_back(kind + "." + element.name);
  if (elements.size() > 1) names.push_back(kind + ".*");
}

/// Places of a kind: each element, then all of them at once; an empty string for the world.
std::vector<std::string> places(const RobotSpec& robot, ElementKind kind) {
  std::vector<std::string> names;
  switch (kind) {
    case ElementKind::joint: add_names(robot.joints, "joint", names); break;
    case ElementKind::body: add_names(robot.bodies, "body", names); break;
    case ElementKind::actuator: add_names(robot.actuators, "actuator", names); break;
    case ElementKind::sensor: add_names(robot.sensors, "sensor", names); break;
    case ElementKind::world: names.emplace_back(); break;
  }
  return names;
}

/// Whether the base already has this effect on these elements.
bool is_there(const ModelDefinition& base, const std::string& effect, const std::string& place) {
  for (const EffectEntry& entry : base.effects) {
    if (entry.effect != effect) continue;
    if (place.empty()) return true;
    const ElementMatch wanted = match_elements(base.structure.robot, {place});
    const ElementMatch present = match_elements(base.structure.robot, entry.where);
    for (const int element : wanted.elements)
      if (wanted.kind == present.kind &&
          std::find(present.elements.begin(), present.elements.end(), element) != present.elements.end())
        return true;
  }
  return false;
}

std::string free_id(const EffectList& effects, const std::string& name) {
  const auto taken = [&](const std::string& id) {
    return std::any_of(effects.begin(), effects.end(), [&](const EffectEntry& entry) { return entry.id == id; });
  };
  std::string id = name;
  for (int number = 2; taken(id); ++number) id = name + "_" + std::to_string(number);
  return id;
}

std::size_t index_of(const std::vector<FreeValue>& free, const std::string& address) {
  for (std::size_t i = 0; i < free.size(); ++i)
    if (free[i].address == address) return i;
  throw Error("the model lost its value " + address + " when an effect was added");
}

Hypothesis make(const Experiment& experiment, const PluginCatalog& catalog, const ModelDefinition& base,
                const EffectDescription& description, EffectEntry entry) {
  Hypothesis hypothesis;
  entry.id = free_id(experiment.model.effects, entry.effect);
  hypothesis.entry = entry;
  hypothesis.placed = placed_entries(entry, base.structure.robot);
  Experiment with = experiment;
  for (const EffectEntry& placed : hypothesis.placed) with = with_effect(std::move(with), placed);
  hypothesis.definition = define_model(with, catalog);
  const std::vector<FreeValue>& free = hypothesis.definition.free;
  for (const FreeValue& value : base.free) hypothesis.base.push_back(index_of(free, value.address));
  for (const EffectEntry& placed : hypothesis.placed)
    for (std::size_t i = 0; i < description.parameters.size(); ++i) {
      const ParameterDeclaration& parameter = description.parameters[i];
      hypothesis.own.push_back(index_of(free, effect_address(placed.id, parameter.name)));
      hypothesis.defaults.push_back(parameter.default_value);
      hypothesis.neutral.push_back(description.neutral.empty() ? parameter.default_value : description.neutral[i]);
    }
  hypothesis.alike = description.look_alikes;
  hypothesis.model = compile(hypothesis.definition.structure, hypothesis.definition.engine);
  return hypothesis;
}

/// Fits a fixed number of the robot; its neutral value is that of the robot file.
Hypothesis make_wrong_value(const Experiment& experiment, const PluginCatalog& catalog, const ModelDefinition& base,
                            EffectEntry entry) {
  Hypothesis hypothesis;
  hypothesis.definition = define_model(with_free_value(experiment, entry), catalog);
  const std::vector<FreeValue>& free = hypothesis.definition.free;
  for (const FreeValue& value : base.free) hypothesis.base.push_back(index_of(free, value.address));
  hypothesis.own = {index_of(free, entry.where.front())};
  hypothesis.neutral = hypothesis.defaults = {free[hypothesis.own.front()].start};
  hypothesis.placed = {entry};
  hypothesis.entry = std::move(entry);
  hypothesis.model = compile(hypothesis.definition.structure, hypothesis.definition.engine);
  return hypothesis;
}

/// Whether fixed numbers of the robot are to be tried.
bool asks_for_wrong_values(const std::vector<std::string>& among) {
  return among.empty() || std::find(among.begin(), among.end(), kWrongValue) != among.end();
}

/// The reason without the plugin's file path, which differs between machines.
std::string reason_of(const PluginListing& listing) {
  const std::string component = to_string(ComponentOrigin{listing.kind, listing.name, listing.file}) + ": ";
  return listing.problem.starts_with(component) ? listing.problem.substr(component.size()) : listing.problem;
}

/// Names of the plugins that can be used; the others are added to `untestable`.
std::vector<std::string> effect_names(const PluginCatalog& catalog, const std::vector<std::string>& among,
                                      std::vector<Untestable>& untestable) {
  std::vector<std::string> names = among;
  std::erase(names, kWrongValue);
  if (!among.empty()) return names;
  for (const PluginListing& listing : catalog.list()) {
    if (listing.kind != "effect") continue;
    if (listing.problem.empty())
      names.push_back(listing.name);
    else
      untestable.push_back({listing.name, "", reason_of(listing), true});
  }
  return names;
}

/// What a sentence says that a component did, without its file; nothing where the sentence does not name it.
std::optional<std::string> deed_of(const ComponentOrigin& origin, const std::string& sentence) {
  const std::string name = to_string(origin) + ": ";
  const std::size_t at = sentence.find(name);
  if (at == std::string::npos) return std::nullopt;
  const std::string deed = sentence.substr(at + name.size());
  return deed.substr(0, deed.find_last_not_of(' ') + 1);
}

/// The effect's description; nothing, and an entry in `untestable`, where it throws.
std::optional<EffectDescription> describe(const PluginCatalog& catalog, const std::string& name,
                                          std::vector<Untestable>& untestable) {
  const PhysicalEffect& effect = catalog.get<PhysicalEffect>(name);
  try {
    return guarded_call(catalog.origin<PhysicalEffect>(name), "describe", [&] { return effect.describe(); });
  } catch (const ComponentError& error) {
    untestable.push_back({name, "", error.reason(), true});
    return std::nullopt;
  }
}

}  // namespace

bool is_length(const FreeValue& free) { return free.unit == "m" && free.scale == Scale::linear; }

bool has_place(const Hypothesis& hypothesis) {
  constexpr std::ptrdiff_t kDimensions = 3;
  return std::count_if(hypothesis.own.begin(), hypothesis.own.end(),
                       [&](std::size_t i) { return is_length(hypothesis.definition.free[i]); }) == kDimensions;
}

std::vector<EffectEntry> placed_entries(const EffectEntry& entry, const RobotSpec& robot) {
  if (entry.where.size() != 1 || entry.where.front() != kEveryJoint || robot.joints.size() <= kMostWithOneValue)
    return {entry};
  std::vector<EffectEntry> placed;
  for (const JointSpec& joint : robot.joints) {
    EffectEntry one = entry;
    one.where = {"joint." + joint.name};
    one.id = entry.id + "_" + std::to_string(placed.size() + 1);
    placed.push_back(std::move(one));
  }
  return placed;
}

std::vector<EffectEntry> placed_entries(const std::vector<EffectEntry>& entries, const RobotSpec& robot) {
  std::vector<EffectEntry> all;
  for (const EffectEntry& entry : entries)
    for (EffectEntry& placed : placed_entries(entry, robot)) all.push_back(std::move(placed));
  return all;
}

std::vector<std::string> Hypothesis::own_names() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < own.size(); ++i)
    names.push_back(member_name(placed[i / parameters()]) + "." + last_name(definition.free[own[i]].address));
  return names;
}

std::string Hypothesis::where() const { return entry.where.empty() ? "world" : entry.where.front(); }

std::vector<double> Hypothesis::values(const std::vector<double>& of_base, const std::vector<double>& of_own) const {
  std::vector<double> all(definition.free.size());
  for (std::size_t i = 0; i < base.size(); ++i) all[base[i]] = of_base[i];
  for (std::size_t i = 0; i < own.size(); ++i) all[own[i]] = of_own[i];
  return all;
}

Untestable without_probes(const Hypothesis& hypothesis, const std::string& failure) {
  Untestable result{hypothesis.entry.effect, hypothesis.where(),
                    "none of its parameter values changes the predictions of these trials"};
  const std::vector<PlacedEffect>& effects = hypothesis.definition.structure.effects;
  const auto own = std::find_if(effects.begin(), effects.end(),
                                [&](const PlacedEffect& placed) { return placed.id == hypothesis.placed.front().id; });
  if (own == effects.end()) return result;
  if (const std::optional<std::string> deed = deed_of(origin_of(*own), failure)) {
    result.reason = *deed;
    result.failed = true;
  }
  return result;
}

Experiment with_effect(Experiment experiment, EffectEntry entry) {
  if (is_wrong_value(entry)) return with_free_value(std::move(experiment), entry);
  if (entry.id.empty()) entry.id = free_id(experiment.model.effects, entry.effect);
  experiment.model.effects.push_back(std::move(entry));
  return experiment;
}

std::vector<Hypothesis> list_hypotheses(const Experiment& experiment, const PluginCatalog& catalog,
                                        const ModelDefinition& base, const std::vector<std::string>& among,
                                        std::vector<Untestable>& untestable) {
  std::vector<Hypothesis> all;
  for (const std::string& name : effect_names(catalog, among, untestable)) {
    const std::optional<EffectDescription> description = describe(catalog, name, untestable);
    if (!description) continue;
    std::vector<Untestable> reasons;
    const std::size_t before = all.size();
    for (const ElementKind kind : description->placements)
      for (const std::string& place : places(base.structure.robot, kind)) {
        if (is_there(base, name, place)) continue;
        EffectEntry entry;
        entry.effect = name;
        if (!place.empty()) entry.where = {place};
        try {
          all.push_back(make(experiment, catalog, base, *description, std::move(entry)));
        } catch (const Error& error) {
          const std::string reason = reason_of(error);
          const std::string deed = deed_of(catalog.origin<PhysicalEffect>(name), reason).value_or(reason);
          reasons.push_back({name, place, deed, blames_plugin(deed)});
        }
      }
    // One reason stands for all places. A failure of the plugin is reported even if other places worked.
    std::stable_partition(reasons.begin(), reasons.end(), [](const Untestable& one) { return one.failed; });
    if (!reasons.empty() && (all.size() == before || reasons.front().failed)) untestable.push_back(reasons.front());
  }
  if (asks_for_wrong_values(among))
    for (EffectEntry& entry : wrong_values(base))
      all.push_back(make_wrong_value(experiment, catalog, base, std::move(entry)));
  return all;
}

std::string member_name(const EffectEntry& entry) {
  return entry.effect + " @ " + (entry.where.empty() ? "world" : entry.where.front());
}

}  // namespace lacuna
