#pragma once

#include "evaluation/complaints.h"
#include "evaluation/model_definition.h"

namespace lacuna {

/// Adds the effects of `[[model.effects]]` to a definition: finds the plugins, checks the entries against
/// what these declare, places them on the robot's elements, and appends their free parameters. A
/// `definition` without bodies stands for a robot that could not be made: entries are then checked as far
/// as that is possible without one.
void place_effects(ModelDefinition& definition, const Experiment& experiment, const PluginCatalog& catalog,
                   Complaints& complaints);

}  // namespace lacuna
