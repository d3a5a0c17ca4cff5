#include "simulation/shared/model_instance.h"

#include "foundation/address.h"
#include "foundation/name_index.h"
#include "foundation/text/number_text.h"
#include "foundation/text/problem.h"
#include "simulation/shared/joint_tree.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna::simulation {
namespace {

constexpr double kBoundTolerance = 1e-9;  // relative: a fit's finite differences may end on a bound

/// An address that a parameter may have, and its destination.
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
  return "the parameter \"" + address + "\" is not a value of the robot or of its effects" +
         did_you_mean(address, known);
}

std::string bounds_complaint(const VariableParameter& parameter, const Place& place) {
  if (!(parameter.lower <= parameter.upper))
    return "the parameter \"" + parameter.address + "\" has its lower bound above its upper bound";
  if (parameter.lower < place.lower || parameter.upper > place.upper)
    return "the parameter \"" + parameter.address + "\" has bounds " + number_text(parameter.lower) + " to " +
           number_text(parameter.upper) + ", beyond the " + number_text(place.lower) + " to " +
           number_text(place.upper) + " that is possible";
  return {};
}

/// Finds the slots of a structure's parameters and setups.
class SlotFinder {
 public:
  explicit SlotFinder(const ModelStructure& structure) : structure_(structure) {
    add_robot_places(structure, places_);
    add_effect_places(structure, places_);
    index_ = NameIndex(places_, [](const Place& place) { return std::string_view(place.address); });
  }

  /// For one setup, or for tests without one: its set values, its own parameters, and the remaining common parameters.
  ParameterSlots::Slots of(const Setup& setup) {
    ParameterSlots::Slots slots;
    std::set<std::string> seen;
    for (const Setup::Value& value : setup.values) add_constant(setup, value, seen, slots);
    add_parameters(setup.name, seen, slots);
    std::set<std::string> given = seen;
    if (!setup.name.empty()) add_parameters({}, given, slots, seen);
    std::stable_partition(slots.begin(), slots.end(),
                          [](const ParameterSlots::Slot& slot) { return slot.scaled_body >= 0; });
    return slots;
  }

  void check_setups() {
    for (const VariableParameter& parameter : structure_.parameters)
      if (!parameter.setup.empty() && std::none_of(structure_.setups.begin(), structure_.setups.end(),
                                                   [&](const Setup& one) { return one.name == parameter.setup; }))
        problems_.add({}, "the parameter \"" + parameter.address + "\" belongs to the setup \"" + parameter.setup +
                              "\", which the model does not have");
  }

  void throw_if_any() const { problems_.throw_if_any(); }

 private:
  const Place* find(const std::string& address) {
    if (const std::optional<std::size_t> place = index_.find(address)) return &places_[*place];
    problems_.add({}, unknown_address(address, places_));
    return nullptr;
  }

  void add_constant(const Setup& setup, const Setup::Value& value, std::set<std::string>& seen,
                    ParameterSlots::Slots& slots) {
    const Place* place = find(value.address);
    if (!place) return;
    if (!seen.insert(value.address).second)
      problems_.add({}, "the setup \"" + setup.name + "\" gives \"" + value.address + "\" twice");
    if (!(value.value >= place->lower && value.value <= place->upper))
      problems_.add({}, "the setup \"" + setup.name + "\" gives \"" + value.address + "\" the value " +
                            number_text(value.value) + ", which is not possible");
    slots.push_back(place->slot);
    slots.back().constant = value.value;
  }

  /// Parameters that belong to `setup`; an address in `elsewhere` already has its slot.
  void add_parameters(const std::string& setup, std::set<std::string>& seen, ParameterSlots::Slots& slots,
                      const std::set<std::string>& elsewhere = {}) {
    for (std::size_t i = 0; i < structure_.parameters.size(); ++i) {
      const VariableParameter& parameter = structure_.parameters[i];
      if (parameter.setup != setup || elsewhere.contains(parameter.address)) continue;
      const Place* place = find(parameter.address);
      if (!place) continue;
      if (!seen.insert(parameter.address).second)
        problems_.add({}, "the parameter \"" + parameter.address + "\" is listed twice");
      if (const std::string complaint = bounds_complaint(parameter, *place); !complaint.empty())
        problems_.add({}, complaint);
      slots.push_back(place->slot);
      slots.back().parameter = static_cast<int>(i);
    }
  }

  const ModelStructure& structure_;
  std::vector<Place> places_;
  NameIndex index_;
  ProblemList problems_;
};

}  // namespace

ParameterSlots::ParameterSlots(const ModelStructure& structure)
    : by_setup_(1 + structure.setups.size()), parameters_(structure.parameters) {
  for (const Setup& setup : structure.setups) setups_.push_back(setup.name);
  // For a robot of a single simulation: it has hundreds of addresses that are not needed.
  if (parameters_.empty() && setups_.empty()) return;
  SlotFinder finder(structure);
  finder.check_setups();
  by_setup_.front() = finder.of({});
  finder.throw_if_any();
  for (std::size_t i = 0; i < setups_.size(); ++i) by_setup_[i + 1] = finder.of(structure.setups[i]);
  finder.throw_if_any();
}

const ParameterSlots::Slots& ParameterSlots::of(const std::string& setup) const {
  if (setup.empty()) return by_setup_.front();
  const auto found = std::find(setups_.begin(), setups_.end(), setup);
  if (found == setups_.end()) throw Error("a test has the setup \"" + setup + "\", which the model does not have");
  return by_setup_[static_cast<std::size_t>(found - setups_.begin()) + 1];
}

ModelInstance::ModelInstance(const ModelStructure& structure, const ParameterSlots& slots)
    : structure_(structure), slots_(slots), robot_(structure.robot) {
  if (std::any_of(slots_.by_setup().begin(), slots_.by_setup().end(),
                  [](const auto& of_setup) { return !of_setup.empty(); }))
    for (const AddressedValue& value : addressed_values(robot_)) robot_values_.push_back(value.value);
  for (const PlacedEffect& effect : structure.effects) effect_values_.push_back(effect.values);
}

double ModelInstance::checked_value(std::span<const double> parameters, int index) const {
  const auto i = static_cast<std::size_t>(index);
  const VariableParameter& declared = slots_.parameters()[i];
  const double margin = kBoundTolerance * std::max({1.0, std::abs(declared.lower), std::abs(declared.upper)});
  if (parameters[i] >= declared.lower - margin && parameters[i] <= declared.upper + margin) return parameters[i];
  throw Error("the parameter \"" + declared.address + "\" is " + number_text(parameters[i]) +
              ", outside of its bounds " + number_text(declared.lower) + " to " + number_text(declared.upper));
}

void ModelInstance::set(std::span<const double> parameters, const ParameterSlots::Slots& slots) {
  // Assigning vectors of equal size keeps their storage, so robot_values_ stay valid.
  robot_ = structure_.robot;
  for (std::size_t i = 0; i < effect_values_.size(); ++i) effect_values_[i] = structure_.effects[i].values;
  for (const ParameterSlots::Slot& slot : slots) {
    const double value = slot.parameter < 0 ? slot.constant : checked_value(parameters, slot.parameter);
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
