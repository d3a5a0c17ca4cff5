#include "app/runs/worker_setup.h"

#include "app/workspace/run_inputs.h"
#include "app/workspace/used_plugins.h"
#include "foundation/processes/memory_limit.h"
#include "foundation/plugins/plugin_call.h"

#include <lacuna/error.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

bool uses_others_plugins(const OpenEeaRun& opened) {
  const std::vector<PluginFileRecord> files = plugins_of_run(opened.opened().experiment, *opened.opened().catalog);
  std::error_code unknown;
  const std::filesystem::path installed = std::filesystem::weakly_canonical(installed_plugins(), unknown);
  return std::any_of(files.begin(), files.end(), [&](const PluginFileRecord& file) {
    return std::filesystem::weakly_canonical(std::filesystem::path(file.file).parent_path(), unknown) != installed;
  });
}

/// Of everything that a model is made from besides the experiment's text.
std::vector<std::string> digests_of(const OpenEeaRun& opened) {
  std::vector<std::string> digests;
  for (const PluginFileRecord& file : plugins_of_run(opened.opened().experiment, *opened.opened().catalog))
    digests.push_back(file.sha256);
  for (const RobotFileRecord& file : robot_files_of(opened.opened().experiment)) digests.push_back(file.sha256);
  std::sort(digests.begin(), digests.end());
  return digests;
}

}  // namespace

std::unique_ptr<WorkerPool> worker_pool(const RunOptions& options, const OpenEeaRun& opened, int threads) {
  if (!options.isolate.value_or(uses_others_plugins(opened))) return nullptr;
  const Experiment& experiment = opened.opened().experiment;
  WorkerTask task;
  task.experiment = experiment.file;
  task.text = experiment.text;
  task.overrides = experiment.overrides;
  task.decided = experiment.decided;
  task.plugin_paths = options.plugin_paths;
  task.evaluation_limit = CallPage::evaluation_limit();
  task.memory = usable_memory() / static_cast<std::uint64_t>(threads);
  task.files = digests_of(opened);
  return std::make_unique<WorkerPool>(std::move(task), options.stop);
}

OpenEeaRun open_worker_run(const WorkerTask& task) {
  CommonOptions options;
  options.experiment = task.experiment;
  options.overrides = task.overrides;
  options.decided = task.decided;
  options.plugin_paths = task.plugin_paths;
  options.stop = {};  // the host ends its workers
  OpenEeaRun opened(open_experiment_without_trials(options, task.text));
  if (digests_of(opened) != task.files)
    throw Error("a plugin or a robot file has changed since the run began; restore it, or begin another run");
  return opened;
}

}  // namespace lacuna
