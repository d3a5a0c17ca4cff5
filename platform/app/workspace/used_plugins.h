#pragma once

#include "config/schema/experiment.h"
#include "loading/plugin_catalog.h"
#include "storage/core/records.h"

#include <vector>

namespace lacuna {

/// The plugin files that an experiment's model and target come from, each once: what a fit depends on.
std::vector<PluginFileRecord> plugins_of_model(const Experiment& experiment, const PluginCatalog& catalog);

/// The same with everything that a run of the algorithm uses.
std::vector<PluginFileRecord> plugins_of_run(const Experiment& experiment, const PluginCatalog& catalog);

}  // namespace lacuna
