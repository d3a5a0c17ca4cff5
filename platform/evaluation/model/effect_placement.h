#pragma once

#include "evaluation/model/complaints.h"
#include "evaluation/model/model_definition.h"

namespace lacuna {

/// Adds the effects of a section to a definition: finds the plugins, checks the entries against their declarations,
/// places them on the robot's elements, and frees their parameters where the source says so. A `definition` without
/// bodies stands for a robot that could not be made: entries are then checked as far as possible.
void place_effects(ModelDefinition& definition, const SystemSource& source, const PluginCatalog& catalog,
                   Complaints& complaints);

}  // namespace lacuna
