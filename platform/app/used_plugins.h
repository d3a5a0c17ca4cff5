#pragma once

#include "config/experiment.h"
#include "loading/plugin_catalog.h"
#include "storage/records.h"

#include <vector>

namespace lacuna {

/// The plugin files that the components of an experiment come from, each once.
std::vector<PluginFileRecord> used_plugins(const Experiment& experiment, const PluginCatalog& catalog);

}  // namespace lacuna
