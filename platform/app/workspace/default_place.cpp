#include "app/workspace/default_place.h"

#include "evaluation/model/model_definition.h"
#include "foundation/address.h"
#include "foundation/processes/guarded_call.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace lacuna {
namespace {

template <class Spec>
void append_names(const std::vector<Spec>& elements, ElementKind kind, std::vector<std::string>& names) {
  for (const Spec& element : elements) names.push_back(fmt::format("{}.{}", to_string(kind), element.name));
}

/// Whether the effect accepts that place; it may have reasons of its own to refuse one of the right kind.
bool accepts(const OpenExperiment& opened, const std::string& effect, const std::string& place) {
  Experiment extended = opened.experiment;
  EffectEntry entry;
  entry.id = "candidate of default_place";  // no id of a file has a space
  entry.effect = effect;
  entry.where = {place};
  extended.model.effects.push_back(std::move(entry));
  try {
    define_model(extended, *opened.catalog);
    return true;
  } catch (const Error&) {
    return false;
  }
}

std::string plural(ElementKind kind) {
  return kind == ElementKind::body ? "bodies" : std::string(to_string(kind)) + "s";
}

}  // namespace

std::vector<std::string> elements_of(const RobotSpec& robot, const std::vector<ElementKind>& kinds) {
  std::vector<std::string> names;
  for (const ElementKind kind : kinds) switch (kind) {
      case ElementKind::joint: append_names(robot.joints, kind, names); break;
      case ElementKind::body: append_names(robot.bodies, kind, names); break;
      case ElementKind::actuator: append_names(robot.actuators, kind, names); break;
      case ElementKind::sensor: append_names(robot.sensors, kind, names); break;
      case ElementKind::world: break;
    }
  return names;
}

std::string question_of_place(const std::string& effect, const std::vector<ElementKind>& kinds,
                              const std::vector<std::string>& places) {
  std::vector<std::string> names;
  std::transform(kinds.begin(), kinds.end(), std::back_inserter(names), plural);
  const std::string acts = fmt::format("{} acts on {}", effect, fmt::join(names, " and "));
  if (places.empty()) return acts + ", which this robot does not have";
  return fmt::format("say where: --where {} ({})", fmt::join(places, " or --where "), acts);
}

std::vector<std::string> default_place(const OpenExperiment& opened, const std::string& effect) {
  std::vector<ElementKind> kinds;
  try {
    const auto& plugin = opened.catalog->get<PhysicalEffect>(effect);
    kinds = guarded_call(opened.catalog->origin<PhysicalEffect>(effect), "describe", [&] {
              return plugin.describe();
            }).placements;
  } catch (const Error&) {
    return {};  // the editor of the list says what is wrong with the effect
  }
  if (std::find(kinds.begin(), kinds.end(), ElementKind::world) != kinds.end()) return {};
  std::vector<std::string> places = elements_of(opened.definition.structure.robot, kinds);
  if (places.size() == 1) return places;
  std::vector<std::string> accepted;
  std::copy_if(places.begin(), places.end(), std::back_inserter(accepted),
               [&](const std::string& place) { return accepts(opened, effect, place); });
  if (accepted.size() == 1) return accepted;
  throw_problem(
      {}, fmt::format("add {}: {}", effect, question_of_place(effect, kinds, accepted.empty() ? places : accepted)));
}

}  // namespace lacuna
