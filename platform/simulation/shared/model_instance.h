#pragma once

#include "simulation/model_structure.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna::simulation {

/// Destinations of the values given to a simulation, resolved once: afterwards the only string in use is a setup's
/// name.
class ParameterSlots {
 public:
  /// Throws `BadInput` for addresses without a match, repeated addresses, unknown setups, values out of bounds, and
  /// bounds in the wrong order or beyond those of the address.
  explicit ParameterSlots(const ModelStructure& structure);

  struct Slot {
    int parameter = -1;  ///< index into the values given, or −1: `constant`
    double constant = 0.0;
    int robot_value = -1;   ///< index into `addressed_values`, or −1 for an effect's
    int effect = -1;        ///< index into the structure's effects
    std::size_t value = 0;  ///< index into that effect's values
    int scaled_body = -1;   ///< a mass that scales the body's inertia
  };
  /// Masses first, so that a moment of inertia that is also given counts after it. An address has one slot.
  using Slots = std::vector<Slot>;

  /// For tests without a setup, then for the structure's setups in their order.
  const std::vector<Slots>& by_setup() const { return by_setup_; }
  /// The slots of tests of that setup; empty: without a setup. Throws `Error` where the model has no such setup.
  const Slots& of(const std::string& setup) const;
  const std::vector<VariableParameter>& parameters() const { return parameters_; }

 private:
  std::vector<std::string> setups_;
  std::vector<Slots> by_setup_;
  std::vector<VariableParameter> parameters_;
};

/// The numbers of one simulation: the robot with the given parameters, and the effects' values. Belongs to a workspace;
/// the structure and slots must outlive it.
class ModelInstance {
 public:
  ModelInstance(const ModelStructure& structure, const ParameterSlots& slots);
  ModelInstance(const ModelInstance&) = delete;
  ModelInstance& operator=(const ModelInstance&) = delete;

  /// Restarts from the structure's numbers with these parameters, not yet amended; `slots` are those of a setup. Throws
  /// `Error` for a value that is not finite or out of its bounds.
  void set(std::span<const double> parameters, const ParameterSlots::Slots& slots);

  RobotSpec& robot() { return robot_; }
  const RobotSpec& robot() const { return robot_; }
  std::span<const double> effect_values(std::size_t effect) const { return effect_values_[effect]; }

 private:
  double checked_value(std::span<const double> parameters, int index) const;

  const ModelStructure& structure_;
  const ParameterSlots& slots_;
  RobotSpec robot_;
  std::vector<double*> robot_values_;  // into robot_, in the order of `addressed_values`
  std::vector<std::vector<double>> effect_values_;
};

}  // namespace lacuna::simulation
