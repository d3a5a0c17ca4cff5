#pragma once

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// Checks that each effect a user names can be added to the model at some place. Throws `BadInput` with a sentence for
/// each that cannot: no plugin has it, the robot has no element of its kind, the model already has it everywhere, or
/// the effect's own objection. Returns the names, each once.
std::vector<std::string> check_effect_filter(const std::vector<std::string>& among, const Experiment& experiment,
                                             const PluginCatalog& catalog, const ModelDefinition& base);

}  // namespace lacuna
