#include "app/commands/commands.h"
#include "app/runs/run_work.h"
#include "app/tasks/submit_run.h"
#include "app/terminal/time_limit.h"
#include "command_line/whole_number.h"
#include "foundation/text/problem.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace lacuna {

void add_run_command(CLI::App& program) {
  auto options = std::make_shared<RunOptions>();  // shared: CLI11 keeps the callback, which must own the options
  auto slurm = std::make_shared<SlurmOptions>();
  CLI::App* command =
      program.add_subcommand("run", "Evolve models that explain a target, and the tests that tell most about it");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_time_limit_option(*command);
  command
      ->add_option("--replicates", options->replicates, "How often the run is repeated, instead of the file's number")
      ->option_text("N")
      ->check(whole_number(1, 1000000));
  CLI::Option* isolate = command->add_flag_callback(
      "--isolate", [options] { options->isolate = true; },
      "Simulate models in worker processes: a plugin that crashes costs a model, not the run (default where a plugin "
      "is not of the installed ones)");
  command
      ->add_flag_callback(
          "--no-isolate", [options] { options->isolate = false; },
          "Simulate models in this process, whatever the plugins")
      ->excludes(isolate);
  CLI::Option* resume =
      command->add_flag("--resume", options->resume,
                        "Go on with this experiment's runs that were not done, or begin where there is none");
  command
      ->add_option(
          "--accept-plugin", options->accepted_plugins,
          "With --resume: go on with another build of this plugin (NAME.so), which is recorded; may be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME")
      ->needs(resume);
  add_slurm_options(*command, *slurm);
  command->callback([options, slurm] {
    if (!slurm->wanted && !slurm->sbatch.empty()) throw_problem({}, "--sbatch needs --executor slurm");
    slurm->wanted ? submit_run(*options, *slurm) : carry_out_run(*options);
  });
}

}  // namespace lacuna
