#include "app/workspace/run_inputs.h"

#include "app/workspace/used_plugins.h"

#include <algorithm>

namespace lacuna {
namespace {

template <class File>
bool has(const std::vector<File>& files, const std::string& sha256) {
  return std::any_of(files.begin(), files.end(), [&](const File& file) { return file.sha256 == sha256; });
}

template <class File>
bool same_files(const std::vector<File>& a, const std::vector<File>& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end(),
                             [](const File& one, const File& other) { return one.sha256 == other.sha256; });
}

/// A plugin that the run did not use cannot have been another.
const PluginFileRecord* build_of(const StoredRun& then, const std::string& name) {
  const auto found = std::find_if(then.plugins.begin(), then.plugins.end(),
                                  [&](const PluginFileRecord& file) { return plugin_name(file) == name; });
  return found == then.plugins.end() ? nullptr : &*found;
}

}  // namespace

std::vector<RobotFileRecord> robot_files_of(const Experiment& experiment) {
  std::vector<RobotFileRecord> files;
  for (const ModelSection* section : {&experiment.model, &experiment.target.simulated.system})
    if (section->declared && !has(files, section->file_digest))
      files.push_back({section->file.string(), section->file_digest});
  return files;
}

std::string plugin_name(const std::filesystem::path& file) { return file.stem().string(); }
std::string plugin_name(const PluginFileRecord& plugin) { return plugin_name(std::filesystem::path(plugin.file)); }

std::vector<std::string> changed_robots(const StoredRun& then, const Experiment& now) {
  std::vector<std::string> changed;
  for (const RobotFileRecord& file : robot_files_of(now))
    if (!then.robots.empty() && !has(then.robots, file.sha256)) changed.push_back("another version of " + file.file);
  return changed;
}

std::vector<ChangedPlugin> changed_plugins(const StoredRun& then, const Experiment& now, const PluginCatalog& catalog) {
  std::vector<ChangedPlugin> changed;
  for (const PluginFileRecord& file : plugins_of_run(now, catalog))
    if (const PluginFileRecord* before = build_of(then, plugin_name(file)); before && !has(then.plugins, file.sha256))
      changed.push_back({*before, file});
  return changed;
}

std::string to_string(const ChangedPlugin& changed) { return "another build of " + changed.now.file; }

std::vector<std::string> changed_files(const StoredRun& then, const Experiment& now, const PluginCatalog& catalog) {
  std::vector<std::string> changed = changed_robots(then, now);
  for (const ChangedPlugin& plugin : changed_plugins(then, now, catalog)) changed.push_back(to_string(plugin));
  return changed;
}

bool same_setting(const StoredRun& a, const StoredRun& b) {
  return a.experiment.text == b.experiment.text && a.experiment.overrides == b.experiment.overrides &&
         a.seed == b.seed && same_files(a.robots, b.robots) && same_files(a.plugins, b.plugins) &&
         same_files(a.earlier_plugins, b.earlier_plugins);
}

}  // namespace lacuna
