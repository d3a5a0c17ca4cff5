#include "app/tasks/freeze_plan.h"

#include "app/runs/open_eea_run.h"
#include "app/terminal/options.h"
#include "app/terminal/scratch_folder.h"
#include "app/workspace/open_experiment.h"
#include "app/workspace/used_plugins.h"
#include "config/experiment_reader.h"
#include "config/overrides.h"
#include "foundation/digest.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace lacuna {
namespace {

/// Each file once, its content read once.
class Inputs {
 public:
  explicit Inputs(TaskPlan& plan) : plan_(plan) {}

  std::size_t number_of(const std::filesystem::path& file) {
    const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
    const auto [known, is_new] = numbers_.try_emplace(whole.string(), plan_.inputs.size());
    if (is_new) plan_.inputs.push_back({whole, sha256_of_file(whole)});
    return known->second;
  }

 private:
  TaskPlan& plan_;
  std::map<std::string, std::size_t> numbers_;
};

std::vector<SweptKey> typed_keys(const std::vector<std::string>& typed) {
  std::vector<SweptKey> keys;
  ProblemList problems;
  for (const std::string& text : typed) try {
      SweptKey key = read_sweep(text);
      if (std::any_of(keys.begin(), keys.end(), [&](const SweptKey& other) { return other.first == key.first; }))
        problems.add({}, "--sweep " + text + ": this key is swept twice; name all values in one --sweep");
      keys.push_back(std::move(key));
    } catch (const Error& wrong) {
      problems.add({}, wrong.what());
    }
  problems.throw_if_any();
  return keys;
}

std::vector<SweptKey> swept_keys(std::vector<SweptKey> keys, const std::vector<SweptKey>& typed) {
  for (const SweptKey& key : typed) {
    const auto same = std::find_if(keys.begin(), keys.end(), [&](const SweptKey& k) { return k.first == key.first; });
    same == keys.end() ? keys.push_back(key) : void(same->second = key.second);
  }
  return keys;
}

/// All effects are candidates of a diagnosis.
std::vector<PluginFileRecord> plugins_of_task(TaskKind kind, const OpenExperiment& opened) {
  if (kind == TaskKind::run) return plugins_of_run(opened.experiment, *opened.catalog);
  std::vector<PluginFileRecord> files = plugins_of_model(opened.experiment, *opened.catalog);
  for (const PluginListing& listing : opened.catalog->list())
    if (listing.kind == "effect") files.push_back({listing.file.string(), listing.sha256, listing.build_id});
  return files;
}

/// The numbers of everything that the results follow from, ascending.
std::vector<std::size_t> inputs_of(TaskKind kind, const OpenExperiment& opened, Inputs& inputs) {
  std::vector<std::size_t> numbers = {inputs.number_of(kThisProgram)};
  for (const std::filesystem::path& file : input_files(opened.experiment)) numbers.push_back(inputs.number_of(file));
  for (const PluginFileRecord& file : plugins_of_task(kind, opened)) numbers.push_back(inputs.number_of(file.file));
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Adds the tasks of one experiment at one point of its sweep.
void add_tasks(const PlanOptions& options, const CommonOptions& point, TaskPlan& plan, Inputs& inputs) {
  OpenExperiment opened = open_experiment(point);
  Task task;
  task.kind = options.kind;
  task.experiment = point.experiment;
  task.name = opened.experiment.name;
  task.settings = point.overrides;
  task.seed = options.seed.value_or(opened.experiment.seed);
  task.inputs = inputs_of(options.kind, opened, inputs);
  if (options.kind == TaskKind::diagnosis && opened.trials.empty())
    throw_problem({point.experiment.string()}, "has no recorded trials; a diagnosis needs some");
  const int replicates = options.kind == TaskKind::run ? options.replicates.value_or(opened.experiment.replicates) : 1;
  if (options.kind == TaskKind::run) const OpenEeaRun ready(std::move(opened));  // says what keeps it from running
  for (task.replicate = 1; task.replicate <= replicates; ++task.replicate) {
    task.id = id_of(task, plan.inputs);
    plan.tasks.push_back(task);
  }
}

/// One value would win, and the plan would say both.
void check_settings(const std::vector<std::string>& overrides, const std::vector<SweptKey>& swept) {
  ProblemList problems;
  for (const std::string& setting : overrides)
    for (const SweptKey& key : swept)
      if (key.first == overridden_key(setting))
        problems.add({},
                     fmt::format("--set {0}: this key is swept; leave out --set, or sweep only this value: --sweep {0}",
                                 setting));
  problems.throw_if_any();
}

/// Adds the tasks at one point of the sweep; problems there name the sweep, not a setting.
void add_point(const PlanOptions& options, CommonOptions point, const std::vector<std::string>& settings,
               TaskPlan& plan, Inputs& inputs) {
  point.overrides.insert(point.overrides.end(), settings.begin(), settings.end());
  try {
    add_tasks(options, point, plan, inputs);
  } catch (const BadInput& bad) {
    std::vector<Problem> problems = bad.problems();
    for (Problem& problem : problems)
      for (const std::string& setting : settings)
        if (problem.location.file == "--set " + setting)
          problem.location.file = fmt::format("{}: sweep: {}", point.experiment.string(), setting);
    throw BadInput(std::move(problems));
  }
}

void add_experiment(const PlanOptions& options, const std::filesystem::path& file, const std::vector<SweptKey>& typed,
                    TaskPlan& plan, Inputs& inputs) {
  const ScratchFolder nothing;
  CommonOptions base;
  base.experiment = std::filesystem::absolute(file).lexically_normal();
  base.overrides = options.overrides;
  base.plugin_paths = plan.plugin_paths;
  base.seed = options.seed;
  base.database = nothing / "none.db";  // stored results of others do not belong to the task
  const Experiment experiment = read_experiment(base.experiment, base.overrides);
  const std::vector<SweptKey> swept =
      swept_keys(options.with_sweep_of_file ? experiment.sweep : std::vector<SweptKey>(), typed);
  check_settings(options.overrides, swept);
  for (const std::vector<std::string>& settings : sweep_points(swept)) add_point(options, base, settings, plan, inputs);
}

void check_different(const TaskPlan& plan, ProblemList& problems) {
  std::map<std::string, const Task*> by_id;
  std::map<std::string, std::filesystem::path> file_of;
  for (const Task& task : plan.tasks) {
    const auto [same, is_new] = by_id.try_emplace(task.id, &task);
    if (!is_new)
      problems.add({task.experiment.string()},
                   fmt::format("is planned twice{}: name each experiment once, and each value of a sweep once",
                               task.settings.empty() ? "" : fmt::format(" with {}", fmt::join(task.settings, ", "))));
    const auto [named, is_first] = file_of.try_emplace(task.name, task.experiment);
    if (named->second != task.experiment)
      problems.add({task.experiment.string()},
                   fmt::format("has the name {}, which {} has too; give each experiment a different name", task.name,
                               named->second.string()));
  }
}

}  // namespace

TaskPlan freeze_plan(const PlanOptions& options) {
  TaskPlan plan{.command = command_line(), .plugin_paths = {}, .inputs = {}, .tasks = {}};
  for (const std::filesystem::path& path : options.plugin_paths)
    plan.plugin_paths.push_back(std::filesystem::absolute(path).lexically_normal());
  const std::vector<SweptKey> typed = typed_keys(options.sweeps);
  Inputs inputs(plan);
  ProblemList problems;
  for (const std::filesystem::path& file : options.experiments) try {
      add_experiment(options, file, typed, plan, inputs);
    } catch (const BadInput& bad) {
      for (const Problem& problem : bad.problems()) problems.add(problem);
    }
  check_different(plan, problems);
  problems.throw_if_any();
  return plan;
}

}  // namespace lacuna
