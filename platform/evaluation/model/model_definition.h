#pragma once

#include <lacuna/parameter.h>

#include "config/schema/experiment.h"
#include "loading/plugin_catalog.h"
#include "simulation/compiled_model.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A value that a fit may change.
struct FreeValue : FreeParameter {
  std::string description = {};
  /// The robot's value, where no file gives a start and that value lies outside the bounds; `start` is the nearest
  /// bound.
  std::optional<double> own = {};
  std::string setup = {};  ///< the only setup that it belongs to; empty: all
};

/// The model section of an experiment with its plugins: it is compiled, fitted and stored.
struct ModelDefinition {
  ModelStructure structure;     ///< its `parameters` are `free`, in this order; its `setups` those of the target
  std::vector<FreeValue> free;  ///< the robot's first, then the effects' in canonical order
  EffectList effects;  ///< canonical: sorted by effect, where, id; elements named one by one, start values complete
  EngineSettings engine;

  std::vector<double> start_values() const;
};

/// A section of an experiment that describes a robot.
struct SystemSource {
  const ModelSection& section;
  std::string key;            ///< name in the file: "model" or "target"
  std::string free;           ///< its table of variable values: "free" or "hidden"
  bool effects_free = false;  ///< the parameters of its effects may vary, too
};

/// Builds the robot, places the effects and resolves every address. Throws `BadInput` with every
/// problem at its place in the file: missing plugins, unknown parameters, values out of declared
/// bounds, addresses that match nothing, effects that cannot be placed there.
ModelDefinition define_model(const Experiment& experiment, const PluginCatalog& catalog);

/// The same for the robot of a simulated target: its free values are the hidden ones, the sensors have the noise that
/// it states, and the effects have their start values. The engine is that of the models, or "ode" where theirs cannot
/// simulate it.
ModelDefinition define_target(const Experiment& experiment, const PluginCatalog& catalog);

}  // namespace lacuna
