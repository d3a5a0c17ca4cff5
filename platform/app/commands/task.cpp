#include "app/commands/commands.h"
#include "app/tasks/carry_out_task.h"
#include "app/terminal/time_limit.h"
#include "command_line/whole_number.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace lacuna {
namespace {

struct TaskOptions {
  std::filesystem::path folder;
  std::size_t number = 0;
  int threads = 0;
  bool quiet = false;
};

/// As many as Slurm has given the task, where it has; 0: one a processor.
int granted_threads() {
  for (const char* variable : {"SLURM_CPUS_PER_TASK", "SLURM_CPUS_ON_NODE"})
    if (const char* const value = std::getenv(variable)) return std::max(0, std::atoi(value));
  return 0;
}

}  // namespace

void add_task_command(CLI::App& program) {
  auto options = std::make_shared<TaskOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* group = program.add_subcommand("task", "Carry out a task of a plan");
  group->require_subcommand(1);
  CLI::App* command = group->add_subcommand("run", "Carry out a task of a plan, or continue an interrupted one");
  command->add_option("folder", options->folder, "Folder of the plan")->required()->option_text("FOLDER");
  command->add_option("number", options->number, "Number of the task, from 0")
      ->required()
      ->option_text("NUMBER")
      ->check(whole_number(0));
  command
      ->add_option("--threads", options->threads, "Threads (default: as many as Slurm granted, else one per processor)")
      ->option_text("N")
      ->check(whole_number(1, 1024));
  add_evaluation_limit_option(*command);
  command->add_flag("--quiet", options->quiet, "Print results only");
  command->callback([options] {
    carry_out_task(TaskFolder(options->folder), options->number,
                   options->threads > 0 ? options->threads : granted_threads(), options->quiet);
  });
}

}  // namespace lacuna
