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
bool was_loaded(const StoredRun& then, const std::filesystem::path& plugin) {
  return std::any_of(then.plugins.begin(), then.plugins.end(), [&](const PluginFileRecord& file) {
    return std::filesystem::path(file.file).filename() == plugin.filename();
  });
}

}  // namespace

std::vector<RobotFileRecord> robot_files_of(const Experiment& experiment) {
  std::vector<RobotFileRecord> files;
  for (const ModelSection* section : {&experiment.model, &experiment.target.simulated.system})
    if (section->declared && !has(files, section->file_digest))
      files.push_back({section->file.string(), section->file_digest});
  return files;
}

std::vector<std::string> changed_files(const StoredRun& then, const Experiment& now, const PluginCatalog& catalog) {
  std::vector<std::string> changed;
  for (const RobotFileRecord& file : robot_files_of(now))
    if (!then.robots.empty() && !has(then.robots, file.sha256)) changed.push_back("another text of " + file.file);
  for (const PluginFileRecord& file : plugins_of_run(now, catalog))
    if (!has(then.plugins, file.sha256) && was_loaded(then, file.file))
      changed.push_back("another build of " + file.file);
  return changed;
}

bool same_setting(const StoredRun& a, const StoredRun& b) {
  return a.experiment.text == b.experiment.text && a.experiment.overrides == b.experiment.overrides &&
         a.seed == b.seed && same_files(a.robots, b.robots) && same_files(a.plugins, b.plugins);
}

}  // namespace lacuna
