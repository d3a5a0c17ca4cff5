#pragma once

#include "config/experiment.h"
#include "loading/plugin_catalog.h"
#include "storage/results/stored_run.h"

#include <string>
#include <vector>

namespace lacuna {

/// The robot files of an experiment's model and target, each once.
std::vector<RobotFileRecord> robot_files_of(const Experiment& experiment);

/// Robot files and plugins that are not those which the run was begun with: "another text of robots/arm.toml", "another
/// build of /usr/lib/lacuna/truncation.so". Nothing is said of robot files where the run did not keep them.
std::vector<std::string> changed_files(const StoredRun& then, const Experiment& now, const PluginCatalog& catalog);

/// Whether two runs differ in nothing but what a replicate may: they have the same experiment, `--set`, seed, robot
/// files and plugins.
bool same_setting(const StoredRun& a, const StoredRun& b);

}  // namespace lacuna
