#include "app/tasks/submit_run.h"

#include "app/tasks/freeze_plan.h"
#include "app/tasks/new_database.h"
#include "app/terminal/time_limit.h"
#include "app/workspace/open_experiment.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "tasks/slurm_jobs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <utility>

namespace lacuna {
namespace {

PlanOptions plan_options(const RunOptions& options) {
  return {.experiments = {options.experiment},
          .overrides = options.overrides,
          .plugin_paths = options.plugin_paths,
          .replicates = options.replicates,
          .seed = options.seed,
          .sweeps = {},
          .with_sweep_of_file = false,  // as where the run stays on this machine
          .kind = TaskKind::run};
}

/// Options of one process have no meaning for many tasks, so they are refused.
void check_options(const RunOptions& options, const SlurmOptions& slurm) {
  struct Given {
    bool is_given;
    const char* name;
    const char* instead;
  };
  constexpr const char* kBySbatch = "give Slurm limits with --sbatch";
  const Given given[] = {
      {options.json.has_value(), "--json", "`lacuna status` prints the progress of the tasks"},
      {options.threads > 0, "--threads", kBySbatch},
      {options.isolate.has_value(), "--isolate and --no-isolate", "each task chooses by its plugins"},
      {options.resume, "--resume", "repeat the same command to submit unfinished tasks"},
      {options.time_limit != nullptr, "--time-limit", kBySbatch}};
  ProblemList problems;
  for (const Given& option : given)
    if (option.is_given)
      problems.add({}, fmt::format("--executor slurm does not take {}; {}", option.name, option.instead));
  for (const std::string& word : slurm.sbatch)
    if (word.starts_with("--ar") || word.starts_with("-a"))  // sbatch takes beginnings of names, too
      problems.add({}, "--sbatch " + word + ": Lacuna sets the array of tasks; leave this option out");
  problems.throw_if_any();
}

/// The merging job may run days later without anybody watching its output.
void check_database(const std::filesystem::path& file) {
  const NewDatabase nothing_yet(file);
  Database::open(file, when_interrupted());
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
          "Where replicates run: local (default), or slurm, as tasks of a job array")
      ->option_text("local|slurm")
      ->check(CLI::IsMember({"local", "slurm"}));
  command
      .add_option_function<std::vector<std::string>>(
          "--sbatch",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts)
              for (std::string& word : words_of(text)) options.sbatch.push_back(std::move(word));
          },
          "With --executor slurm: options for sbatch, as in --sbatch \"--partition=long --time=2:00:00\"; may be "
          "repeated")
      ->allow_extra_args(false)
      ->option_text("OPTIONS");
}

void submit_run(const RunOptions& options, const SlurmOptions& slurm) {
  check_options(options, slurm);
  const TaskPlan plan = freeze_plan(plan_options(options));
  const std::string& name = plan.tasks.front().name;
  const std::filesystem::path database =
      std::filesystem::absolute(options.database.empty() ? name + ".db" : options.database.string());
  check_database(database);
  const TaskFolder folder = TaskFolder::make(std::filesystem::absolute(name + ".plan"), plan, options.stop);
  const std::size_t open = folder.open_tasks().size();
  if (open == 0) return say_finished(folder, database);
  const SlurmJobs jobs = submit_to_slurm(folder, std::filesystem::read_symlink(kThisProgram), slurm.sbatch, database);
  fmt::print("Slurm job {}: {}; job {} then merges them into {}\n→ lacuna status {}\n", jobs.array,
             counted(open, "task"), jobs.merge, plain_text(database.string()), shell_word(folder.path().string()));
}

}  // namespace lacuna
