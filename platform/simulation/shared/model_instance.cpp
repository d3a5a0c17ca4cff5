#include "simulation/shared/model_instance.h"

#include "foundation/address.h"
#include "foundation/problem.h"
#include "simulation/shared/joint_tree.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna::simulation {
namespace {

constexpr double kBoundTolerance = 1e-9;  // relative: a fit's finite differences may end on a bound

/// An address that a parameter may have, and what is written there.
struct Place {
  std::string address;
  double lower, upper;
  ParameterSlots::Slot slot;
};

void add_robot_places(const ModelStructure& structure, std::vector<Place>& places) {
  RobotSpec robot = structure.robot;
  int index = 0;
  for (const AddressedValue& value : addressed_values(robot)) {
    Place place{value.address, value.lower, value.upper, {.robot_value = index++}};
    for (std::size_t body = 0; body < robot.bodies.size(); ++body)
      if (value.value == &robot.bodies[body].mass && robot.bodies[body].inertia_scales_with_mass)
        place.slot.scaled_body = static_cast<int>(body);
    places.push_back(place);
  }
}

void add_effect_places(const ModelStructure& structure, std::vector<Place>& places) {
  for (std::size_t effect = 0; effect < structure.effects.size(); ++effect) {
    const PlacedEffect& placed = structure.effects[effect];
    const ParameterDeclarations declared =
        guarded_call(origin_of(placed), "describe", [&] { return placed.effect->describe(); }).parameters;
    for (std::size_t value = 0; value < declared.size(); ++value)
      places.push_back({effect_address(placed.id, declared[value].name),
                        declared[value].lower,
                        declared[value].upper,
                        {.effect = static_cast<int>(effect), .value = value}});
  }
}

std::string unknown_address(const std::string& address, const std::vector<Place>& places) {
  std::vector<std::string> known;
  for (const Place& place : places) known.push_back(place.address);
  return "the parameter \"" + address + "\" is no value of the robot or of its effects" + did_you_mean(address, known);
}

std::string bounds_complaint(const VariableParameter& parameter, const Place& place) {
  if (!(parameter.lower <= parameter.upper))
    return "the parameter \"" + parameter.address + "\" has its lower bound above its upper bound";
  if (parameter.lower < place.lower || parameter.upper > place.upper)
    return "the parameter \"" + parameter.address + "\" has bounds " + std::to_string(parameter.lower) + " to " +
           std::to_string(parameter.upper) + ", beyond the " + std::to_string(place.lower) + " to " +
           std::to_string(place.upper) + " that it may have";
  return {};
}

}  // namespace

ParameterSlots::ParameterSlots(const ModelStructure& structure) : parameters_(structure.parameters) {
  if (parameters_.empty()) return;  // a robot of its own a simulation: hundreds of addresses that nobody asks for
  std::vector<Place> places;
  add_robot_places(structure, places);
  add_effect_places(structure, places);
  ProblemList problems;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const VariableParameter& parameter = parameters_[i];
    const auto place = std::find_if(places.begin(), places.end(),
                                    [&](const Place& candidate) { return candidate.address == parameter.address; });
    if (place == places.end()) {
      problems.add({}, unknown_address(parameter.address, places));
      continue;
    }
    if (!seen.insert(parameter.address).second)
      problems.add({}, "the parameter \"" + parameter.address + "\" is listed twice");
    if (const std::string complaint = bounds_complaint(parameter, *place); !complaint.empty())
      problems.add({}, complaint);
    slots_.push_back(place->slot);
    slots_.back().parameter = i;
  }
  problems.throw_if_any();
  std::stable_partition(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.scaled_body >= 0; });
}

ModelInstance::ModelInstance(const ModelStructure& structure, const ParameterSlots& slots)
    : structure_(structure), slots_(slots), robot_(structure.robot) {
  if (!slots_.slots().empty())
    for (const AddressedValue& value : addressed_values(robot_)) robot_values_.push_back(value.value);
  for (const PlacedEffect& effect : structure.effects) effect_values_.push_back(effect.values);
}

void ModelInstance::set(std::span<const double> parameters) {
  // Assigning vectors of equal size keeps their storage, so robot_values_ stay valid.
  robot_ = structure_.robot;
  for (std::size_t i = 0; i < effect_values_.size(); ++i) effect_values_[i] = structure_.effects[i].values;
  for (const ParameterSlots::Slot& slot : slots_.slots()) {
    const VariableParameter& declared = slots_.parameters()[slot.parameter];
    const double value = parameters[slot.parameter];
    const double margin = kBoundTolerance * std::max({1.0, std::abs(declared.lower), std::abs(declared.upper)});
    if (!(value >= declared.lower - margin && value <= declared.upper + margin))
      throw Error("the parameter \"" + declared.address + "\" is " + std::to_string(value) +
                  ", outside of its bounds " + std::to_string(declared.lower) + " to " +
                  std::to_string(declared.upper));
    if (slot.robot_value < 0) {
      effect_values_[static_cast<std::size_t>(slot.effect)][slot.value] = value;
      continue;
    }
    double& target = *robot_values_[static_cast<std::size_t>(slot.robot_value)];
    if (slot.scaled_body >= 0) {
      InertiaSpec& inertia = robot_.bodies[static_cast<std::size_t>(slot.scaled_body)].inertia;
      for (double* moment : {&inertia.xx, &inertia.yy, &inertia.zz, &inertia.xy, &inertia.xz, &inertia.yz})
        *moment *= value / target;
    }
    target = value;
  }
}

}  // namespace lacuna::simulation
