#include "evaluation/model/possible_values.h"

#include "foundation/address.h"
#include "foundation/placement_unit.h"

#include <cmath>

namespace lacuna {
namespace {

void add_robot_places(const ModelDefinition& definition, std::vector<PossibleValue>& places) {
  RobotSpec robot = definition.structure.robot;
  for (const AddressedValue& value : addressed_values(robot))
    places.push_back({{{value.address, value.unit, value.lower, value.upper, *value.value}},
                      value.lower,
                      value.upper,
                      std::isfinite(value.lower) && std::isfinite(value.upper)});
}

void add_effect_places(const ModelDefinition& definition, std::vector<PossibleValue>& places) {
  for (const PlacedEffect& placed : definition.structure.effects) {
    const ParameterDeclarations declared =
        guarded_call(origin_of(placed), "describe", [&] { return placed.effect->describe(); }).parameters;
    for (std::size_t i = 0; i < declared.size(); ++i) {
      const std::string unit = placed.elements.empty() ? declared[i].unit
                                                       : unit_at(declared[i].unit, definition.structure.robot,
                                                                 placed.kind, placed.elements.front());
      places.push_back({{{effect_address(placed.id, declared[i].name), unit, declared[i].lower, declared[i].upper,
                          placed.values[i], declared[i].scale},
                         declared[i].description},
                        declared[i].lower,
                        declared[i].upper});
    }
  }
}

}  // namespace

std::vector<PossibleValue> possible_values(const ModelDefinition& definition) {
  std::vector<PossibleValue> places;
  add_robot_places(definition, places);
  add_effect_places(definition, places);
  return places;
}

std::string unit_of_value(const ModelDefinition& definition, const std::string& pattern) {
  for (const PossibleValue& one : possible_values(definition))
    if (matches(pattern, one.value.address)) return one.value.unit;
  return "";
}

}  // namespace lacuna
