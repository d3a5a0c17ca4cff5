#include "app/tasks/submit_run.h"

#include "app/tasks/freeze_plan.h"
#include "app/workspace/rig.h"
#include "foundation/counted.h"
#include "foundation/plain_text.h"
#include "foundation/problem.h"
#include "foundation/shell_word.h"
#include "tasks/slurm_jobs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sstream>

namespace lacuna {
namespace {

PlanOptions plan_options(const RunOptions& options) {
  return {.experiments = {options.experiment},
          .overrides = options.overrides,
          .plugin_paths = options.plugin_paths,
          .replicates = options.replicates,
          .seed = options.seed,
          .sweeps = {},
          .kind = TaskKind::run};
}

/// Where all tasks are done, their merge is all that is left.
void say_finished(const TaskFolder& folder, const std::filesystem::path& database) {
  fmt::print("all {} of {} are done\n→ lacuna merge {} {}\n", counted(folder.plan().tasks.size(), "task"),
             plain_text(folder.path().string()), shell_word(database.string()), shell_word(folder.path().string()));
}

}  // namespace

void add_slurm_options(CLI::App& command, SlurmOptions& options) {
  command
      .add_option_function<std::string>(
          "--executor", [&options](const std::string& name) { options.wanted = name == "slurm"; },
          "Where the replicates run: local (default), or slurm, which gets each as a task of a job array")
      ->option_text("local|slurm")
      ->check(CLI::IsMember({"local", "slurm"}));
  command
      .add_option_function<std::vector<std::string>>(
          "--sbatch",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              std::istringstream words(text);
              for (std::string word; words >> word;) options.sbatch.push_back(word);
            }
          },
          "With --executor slurm: options for sbatch, as in --sbatch \"--partition=long --time=2:00:00\"; may be "
          "repeated")
      ->allow_extra_args(false)
      ->option_text("OPTIONS");
}

void submit_run(const RunOptions& options, const SlurmOptions& slurm) {
  const TaskPlan plan = freeze_plan(plan_options(options));
  const std::string& name = plan.tasks.front().name;
  const std::filesystem::path database =
      std::filesystem::absolute(options.database.empty() ? name + ".db" : options.database.string());
  const TaskFolder folder = TaskFolder::make(std::filesystem::absolute(name + ".plan"), plan);
  const std::size_t open = folder.open_tasks().size();
  if (open == 0) return say_finished(folder, database);
  const SlurmJobs jobs = submit_to_slurm(folder, std::filesystem::read_symlink(kThisProgram), slurm.sbatch, database);
  fmt::print("Slurm job {}: {}; job {} then merges them into {}\n→ lacuna status {}\n", jobs.array,
             counted(open, "task"), jobs.merge, plain_text(database.string()), shell_word(folder.path().string()));
}

}  // namespace lacuna
