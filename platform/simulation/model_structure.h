#pragma once

#include "foundation/processes/guarded_call.h"

#include <lacuna/physical_effect.h>
#include <lacuna/robot_spec.h>
#include <lacuna/setup.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// An effect on its elements, ready for an engine. The catalog owns the component.
struct PlacedEffect {
  std::string id;
  std::string name;  ///< the plugin's
  const PhysicalEffect* effect = nullptr;
  ElementKind kind = ElementKind::world;
  std::vector<int> elements;   ///< indices into the robot's list of that kind
  std::vector<double> values;  ///< one per declared parameter
  std::filesystem::path file;  ///< the plugin's; empty: built into the program
};

/// The effect's component, as named in messages.
inline ComponentOrigin origin_of(const PlacedEffect& placed) {
  return {.kind = "effect", .name = placed.name, .file = placed.file};
}

/// A number that is given for each simulation. Its address is one of `addressed_values` (foundation/address.h) or
/// `effect.<id>.<parameter>`.
struct VariableParameter {
  std::string address;
  double lower = 0.0;  ///< bounds the size of delay lines and effect states
  double upper = 0.0;
  std::string setup = {};  ///< the only setup that it belongs to; empty: all without their own value for the address
};

/// The input of an engine's compilation. All strings are resolved then and not used afterwards.
struct ModelStructure {
  RobotSpec robot;
  std::vector<PlacedEffect> effects;          ///< any order; the engine sorts them
  std::vector<VariableParameter> parameters;  ///< defines the order of the values given to `simulate`
  std::vector<Setup> setups = {};  ///< with full addresses; every setup that a parameter belongs to is one of them
};

}  // namespace lacuna
