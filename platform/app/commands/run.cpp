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
  CLI::App* command = program.add_subcommand(
      "run", "Run the Estimation-Exploration Algorithm: evolve models of a target and tests for it");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_time_limit_option(*command, *options);
  command->add_option("--replicates", options->replicates, "Number of replicates (default: the file's number)")
      ->option_text("N")
      ->check(whole_number(1, 1000000));
  CLI::Option* isolate = command->add_flag_callback(
      "--isolate", [options] { options->isolate = true; },
      "Simulate models in worker processes: a plugin crash then loses one model, not the run (default if third-party "
      "plugins are used)");
  command
      ->add_flag_callback(
          "--no-isolate", [options] { options->isolate = false; },
          "Simulate models in this process, even with third-party plugins (not with --isolate)")
      ->excludes(isolate);
  CLI::Option* resume = command->add_flag("--resume", options->resume,
                                          "Continue this experiment's unfinished runs; if it has no run, begin one");
  command
      ->add_option("--accept-plugin", options->accepted_plugins,
                   "With --resume: continue with another build of this plugin (NAME.so); the database records it; may "
                   "be repeated")
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
