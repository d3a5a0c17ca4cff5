#include "app/commands/commands.h"
#include "app/terminal/time_limit.h"
#include "app/workspace/diagnosis_work.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace lacuna {

void add_diagnose_command(CLI::App& program) {
  auto options = std::make_shared<DiagnoseOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("diagnose", "Find the physical effect that the model is missing");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_time_limit_option(*command, *options);
  command
      ->add_option("--among", options->among,
                   "Try only these effects (default: all). The name wrong_value stands for the fixed values of the "
                   "robot file: each is tried as a free value")
      ->option_text("EFFECT ...");
  command->add_option("--out", options->out, "Folder for pictures (SVG)")->option_text("FOLDER");
  command->callback([options] {
    try {
      carry_out_diagnosis(*options);
    } catch (const TimeIsUp&) {
      throw;
    } catch (const Interrupted& interruption) {
      throw Interrupted(std::string(interruption.what()) + "; to continue, run the same command again");
    }
  });
}

}  // namespace lacuna
