#pragma once

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// Whether each effect that a user asks for by name can be added to the model somewhere. Throws `BadInput` with a
/// sentence for each that cannot: no plugin has it, the robot has no element of its kind, the model has it everywhere
/// already, or what the effect itself objects to. Returns them, each once.
std::vector<std::string> check_among(const std::vector<std::string>& among, const Experiment& experiment,
                                     const PluginCatalog& catalog, const ModelDefinition& base);

}  // namespace lacuna
