#pragma once

#include "config/schema/experiment.h"
#include "loading/plugin_catalog.h"
#include "storage/results/stored_run.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// The robot files of an experiment's model and target, each once.
std::vector<RobotFileRecord> robot_files_of(const Experiment& experiment);

/// A plugin that a run was begun, or went on, with, and the build of it that there is now.
struct ChangedPlugin {
  PluginFileRecord before, now;
};

/// As users name a plugin's file: "hostile" for /home/ada/plugins/hostile.so.
std::string plugin_name(const PluginFileRecord& plugin);
std::string plugin_name(const std::filesystem::path& file);

std::vector<std::string> changed_robots(const StoredRun& then, const Experiment& now);
std::vector<ChangedPlugin> changed_plugins(const StoredRun& then, const Experiment& now, const PluginCatalog& catalog);
std::string to_string(const ChangedPlugin& changed);

/// Robot files and plugins that are not those which the run was begun with: "another text of robots/arm.toml", "another
/// build of /usr/lib/lacuna/truncation.so". Nothing is said of robot files where the run did not keep them.
std::vector<std::string> changed_files(const StoredRun& then, const Experiment& now, const PluginCatalog& catalog);

/// Whether two runs differ in nothing but what a replicate may: they have the same experiment, `--set`, seed, robot
/// files and plugins, those of before included.
bool same_setting(const StoredRun& a, const StoredRun& b);

}  // namespace lacuna
