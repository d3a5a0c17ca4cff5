#pragma once

#include "config/experiment.h"
#include "loading/plugin_catalog.h"
#include "simulation/compiled_model.h"

#include <string>
#include <vector>

namespace lacuna {

/// A value that a fit may change.
struct FreeValue {
  std::string address;  ///< `body.arm.mass`, `effect.friction.torque`
  std::string unit;
  double lower = 0.0;
  double upper = 0.0;
  double start = 0.0;
  Scale scale = Scale::linear;
  std::string description;
};

/// The model section of an experiment with its plugins: what is compiled, fitted and stored.
struct ModelDefinition {
  ModelStructure structure;     ///< its `parameters` are `free`, in this order
  std::vector<FreeValue> free;  ///< the robot's first, then the effects' in canonical order
  EffectList effects;  ///< canonical: sorted by effect, where, id; elements named singly, start values complete
  EngineSettings engine;

  std::vector<double> start_values() const;
};

/// Builds the robot, places the effects and resolves every address. Throws `BadInput` with every
/// problem at its place in the file: missing plugins, unknown parameters, values out of declared
/// bounds, addresses that match nothing, effects that cannot be placed there.
ModelDefinition define_model(const Experiment& experiment, const PluginCatalog& catalog);

}  // namespace lacuna
