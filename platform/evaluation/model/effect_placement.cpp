#include "evaluation/model/effect_placement.h"

#include "foundation/address.h"
#include "foundation/text/counted.h"
#include "foundation/placement_unit.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

namespace lacuna {
namespace {

/// A valid entry of the list, with its plugin and elements.
struct Placement {
  EffectEntry entry;
  EffectDescription description;
  PlacedEffect placed;
};

std::vector<std::string> names_of(const ParameterDeclarations& declarations) {
  std::vector<std::string> names;
  for (const ParameterDeclaration& declaration : declarations) names.push_back(declaration.name);
  return names;
}

std::string parameter_list(const ParameterDeclarations& declarations) {
  if (declarations.empty()) return "; it has no parameters";
  std::string text;
  for (const std::string& name : names_of(declarations)) text += (text.empty() ? "; it has " : ", ") + name;
  return text;
}

std::string name_of(ElementKind kind) {
  return kind == ElementKind::world ? "the world" : with_article(std::string(to_string(kind)));
}

bool same_elements(const RobotSpec& a, const RobotSpec& b) {
  return a.bodies.size() == b.bodies.size() && a.joints.size() == b.joints.size() &&
         a.actuators.size() == b.actuators.size() && a.sensors.size() == b.sensors.size();
}

/// Unit of a parameter at the effect's place.
std::string unit_of(const ParameterDeclaration& declaration, const RobotSpec& robot, const PlacedEffect& placed) {
  return placed.elements.empty() ? declaration.unit
                                 : unit_at(declaration.unit, robot, placed.kind, placed.elements.front());
}

/// Checks one entry of the list, `key` being its place.
class EntryCheck {
 public:
  EntryCheck(std::string key, EffectEntry entry, const PluginCatalog& catalog, Complaints& complaints)
      : key_(std::move(key)),
        entry_(std::move(entry)),
        is_without_place_(entry_.where.empty()),
        origin_(catalog.origin<PhysicalEffect>(entry_.effect)),
        catalog_(catalog),
        complaints_(complaints) {}

  std::optional<Placement> run(const RobotSpec& robot) {
    const bool known = find_plugin();
    if (known) check_parameters();
    if (!robot.bodies.empty() && match(robot) && known) {
      check_kind();
      check_units(robot);
      if (good_) try_amend(robot);
    }
    if (!good_ || robot.bodies.empty()) return std::nullopt;
    return Placement{entry_, description_, placed_};
  }

 private:
  template <class What>
  void complain(const std::string& subkey, const What& what) {
    complaints_.add(key_ + subkey, what);
    good_ = false;
  }

  bool find_plugin() {
    try {
      placed_.effect = &catalog_.get<PhysicalEffect>(entry_.effect);
      description_ = guarded_call(origin_, "describe", [this] { return placed_.effect->describe(); });
    } catch (const Error& error) {
      complain(".effect", error);
      return false;
    }
    placed_.id = entry_.id;
    placed_.name = entry_.effect;
    placed_.file = origin_.file;
    return good_;
  }

  void check_parameters() {
    const std::vector<std::string> names = names_of(description_.parameters);
    const auto unknown = [&](const std::string& subkey, const std::string& name) {
      if (std::find(names.begin(), names.end(), name) != names.end()) return false;
      complain(subkey, entry_.effect + " has no parameter \"" + name + "\"" + did_you_mean(name, names) +
                           parameter_list(description_.parameters));
      return true;
    };
    for (const auto& [name, value] : entry_.start) unknown(".start." + name, name);
    for (std::size_t i = 0; i < entry_.fixed.size(); ++i) unknown(".fixed[" + std::to_string(i) + "]", entry_.fixed[i]);
    for (const ParameterDeclaration& declaration : description_.parameters) {
      const double value = entry_.start.try_emplace(declaration.name, declaration.default_value).first->second;
      placed_.values.push_back(value);
      if (value >= declaration.lower && value <= declaration.upper) continue;
      const std::string unit = unit_in_words(declaration.unit);
      complain(".start." + declaration.name, format_quantity(value, "1") + " is outside the range of " + entry_.effect +
                                                 ", " + format_quantity(declaration.lower, "1") + " to " +
                                                 format_quantity(declaration.upper, "1") + " " + unit);
    }
    for (const auto& [name, bounds] : entry_.range)
      if (!unknown(".range." + name, name)) check_range(name, bounds);
  }

  /// The range lies within the declared one, and the start within the range.
  void check_range(const std::string& name, const std::pair<double, double>& bounds) {
    const auto declaration = std::find_if(description_.parameters.begin(), description_.parameters.end(),
                                          [&](const ParameterDeclaration& each) { return each.name == name; });
    const auto text = [](double lower, double upper) {
      return format_quantity(lower, "1") + " to " + format_quantity(upper, "1");
    };
    const double start = entry_.start.at(name);
    if (bounds.first < declaration->lower || bounds.second > declaration->upper)
      complain(".range." + name, text(bounds.first, bounds.second) + " exceeds the range of " + entry_.effect + ", " +
                                     text(declaration->lower, declaration->upper) + " " +
                                     unit_in_words(declaration->unit));
    else if (start < bounds.first || start > bounds.second)
      complain(".range." + name, "the start value, " + format_quantity(start, "1") + ", lies outside " +
                                     text(bounds.first, bounds.second) + "; give a start value within it");
  }

  /// Patterns one by one first, so that each bad one is named at its place.
  bool match(const RobotSpec& robot) {
    bool found = true;
    for (std::size_t i = 0; i < entry_.where.size(); ++i) {
      try {
        match_elements(robot, {entry_.where[i]});
      } catch (const Error& error) {
        complain(".where[" + std::to_string(i) + "]", error);
        found = false;
      }
    }
    if (!found) return false;
    try {
      ElementMatch matched = match_elements(robot, entry_.where);
      placed_.kind = matched.kind;
      placed_.elements = std::move(matched.elements);
    } catch (const Error& error) {
      complain(".where", error);
      return false;
    }
    name_elements(robot);
    return true;
  }

  /// The names of the elements instead of patterns, so that equal models have equal lists.
  void name_elements(const RobotSpec& robot) {
    entry_.where.clear();
    for (const int element : placed_.elements) {
      const auto index = static_cast<std::size_t>(element);
      const std::string prefix = std::string(to_string(placed_.kind)) + ".";
      switch (placed_.kind) {
        case ElementKind::joint: entry_.where.push_back(prefix + robot.joints[index].name); break;
        case ElementKind::body: entry_.where.push_back(prefix + robot.bodies[index].name); break;
        case ElementKind::actuator: entry_.where.push_back(prefix + robot.actuators[index].name); break;
        case ElementKind::sensor: entry_.where.push_back(prefix + robot.sensors[index].name); break;
        case ElementKind::world: break;
      }
    }
  }

  void check_kind() {
    const std::vector<ElementKind>& allowed = description_.placements;
    if (std::find(allowed.begin(), allowed.end(), placed_.kind) != allowed.end()) return;
    std::string text;
    for (const ElementKind kind : allowed) text += (text.empty() ? "" : " or ") + name_of(kind);
    if (is_without_place_ && !allowed.empty())
      return complain(".where", fmt::format("is missing: {} acts on {}; say on which one, as in where = [\"{}.NAME\"]",
                                            entry_.effect, text, to_string(allowed.front())));
    complain(".where", entry_.effect + " cannot be placed on " + name_of(placed_.kind) + "; place it on " + text);
  }

  void check_units(const RobotSpec& robot) {
    for (const ParameterDeclaration& declaration : description_.parameters) {
      const std::string unit = unit_of(declaration, robot, placed_);
      complaints_.check_unit(key_ + ".start." + declaration.name, unit);
      for (const char* bound : {"[0]", "[1]"})
        complaints_.check_unit(key_ + ".range." + declaration.name + bound, unit);
      for (const int element : placed_.elements) {
        const std::string other = unit_at(declaration.unit, robot, placed_.kind, element);
        if (other == unit) continue;
        complain(".where", fmt::format("{} would be in {} and in {} at once; give hinges and sliders an entry each",
                                       declaration.name, unit, other));
        return;
      }
    }
  }

  /// An effect may object to its place; it does so when it amends the robot.
  void try_amend(const RobotSpec& robot) {
    try {
      const EffectHooks hooks = guarded_call(origin_, "stages", [this] { return placed_.effect->hooks(); });
      if (!hooks.amends_robot) return;
      RobotSpec copy = robot;
      const EffectContext context{placed_.values, placed_.elements, placed_.kind, 0.0};
      guarded_call(origin_, "amend", [&] { placed_.effect->amend(copy, context); });
      if (!same_elements(copy, robot))
        throw ComponentError(origin_,
                             "it added or removed elements of the robot, which an effect may not; repair the plugin");
    } catch (const Error& error) {
      complain("", error);
    }
  }

  std::string key_;
  EffectEntry entry_;
  bool is_without_place_;
  ComponentOrigin origin_;
  const PluginCatalog& catalog_;
  Complaints& complaints_;
  EffectDescription description_;
  PlacedEffect placed_;
  bool good_ = true;
};

void free_parameters(const Placement& placement, ModelDefinition& definition) {
  const EffectEntry& entry = placement.entry;
  for (std::size_t i = 0; i < placement.description.parameters.size(); ++i) {
    const ParameterDeclaration& declaration = placement.description.parameters[i];
    if (std::find(entry.fixed.begin(), entry.fixed.end(), declaration.name) != entry.fixed.end()) continue;
    const std::string unit = unit_of(declaration, definition.structure.robot, placement.placed);
    const auto range = entry.range.find(declaration.name);
    const auto [lower, upper] =
        range == entry.range.end() ? std::pair(declaration.lower, declaration.upper) : range->second;
    definition.free.push_back({{effect_address(entry.id, declaration.name), unit, lower, upper,
                                placement.placed.values[i], declaration.scale},
                               declaration.description});
  }
}

}  // namespace

void place_effects(ModelDefinition& definition, const SystemSource& source, const PluginCatalog& catalog,
                   Complaints& complaints) {
  std::vector<Placement> placements;
  for (std::size_t i = 0; i < source.section.effects.size(); ++i) {
    EntryCheck check(source.key + ".effects[" + std::to_string(i) + "]", source.section.effects[i], catalog,
                     complaints);
    if (std::optional<Placement> placement = check.run(definition.structure.robot)) {
      std::sort(placement->entry.fixed.begin(), placement->entry.fixed.end());
      placements.push_back(std::move(*placement));
    }
  }
  std::sort(placements.begin(), placements.end(), [](const Placement& a, const Placement& b) {
    return std::tie(a.entry.effect, a.entry.where, a.entry.id) < std::tie(b.entry.effect, b.entry.where, b.entry.id);
  });
  for (Placement& placement : placements) {
    if (source.effects_free) free_parameters(placement, definition);
    definition.effects.push_back(std::move(placement.entry));
    definition.structure.effects.push_back(std::move(placement.placed));
  }
}

}  // namespace lacuna
