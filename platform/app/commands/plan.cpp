#include "app/commands/commands.h"
#include "app/tasks/freeze_plan.h"
#include "app/terminal/options.h"
#include "command_line/whole_number.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "tasks/task_folder.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace lacuna {
namespace {

struct PlanCommand : PlanOptions {
  CommonOptions common;  ///< the plugin folders
  std::filesystem::path out;
};

void make_plan(PlanCommand options) {
  if (options.kind == TaskKind::diagnosis && options.replicates)
    throw_problem({}, "--replicates repeats runs, and a diagnosis is made once; leave it out");
  options.plugin_paths = options.common.plugin_paths;
  const TaskFolder folder = TaskFolder::make(options.out, freeze_plan(options), when_interrupted());
  const std::string typed = shell_word(options.out.string());
  fmt::print("{}: {}\n", plain_text(options.out.string()), counted(folder.plan().tasks.size(), "task"));
  if (const std::vector<std::size_t> open = folder.open_tasks(); !open.empty())
    fmt::print("→ lacuna task run {} {}\n", typed, open.front());
  fmt::print("→ lacuna status {}\n", typed);
}

}  // namespace

void add_plan_command(CLI::App& program) {
  auto options = std::make_shared<PlanCommand>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("plan", "Split runs or diagnoses into tasks that any machine can carry out");
  command->add_option("experiments", options->experiments, "Experiment files (TOML)")
      ->required()
      ->option_text("FILE...");
  command->add_option("--out", options->out, "New folder for the plan (required)")->required()->option_text("FOLDER");
  command->add_flag_callback(
      "--diagnose", [options] { options->kind = TaskKind::diagnosis; },
      "Make each task a diagnosis (default: a replicate of a run)");
  command
      ->add_option("--replicates", options->replicates, "Number of replicates of each run (default: the file's number)")
      ->option_text("N")
      ->check(whole_number(1, 1000000));
  command
      ->add_option("--sweep", options->sweeps,
                   "Vary a key: --sweep engine.step=0.001,0.002; may be repeated; all combinations are planned, also "
                   "with the keys in the file's section [sweep]")
      ->allow_extra_args(false)
      ->option_text("KEY=A,B,...");
  command->add_option("--seed", options->seed, "Seed (default: the files')")->option_text("N")->check(whole_number(0));
  command->add_option("--set", options->overrides, "Override a key of the files; may be repeated")
      ->allow_extra_args(false)
      ->option_text("KEY=VALUE");
  add_plugin_path_option(*command, options->common);
  command->callback([options] { make_plan(*options); });
}

}  // namespace lacuna
