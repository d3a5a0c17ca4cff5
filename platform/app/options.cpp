#include "app/options.h"

#include <CLI/CLI.hpp>

namespace lacuna {
namespace {

std::string typed;

}  // namespace

void set_command_line(int argc, char** argv) {
  typed = "lacuna";
  for (int i = 1; i < argc; ++i) typed += std::string(" ") + argv[i];
}

const std::string& command_line() { return typed; }

void add_plugin_path_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--plugin-path", options.plugin_paths,
                     "Folder with plugins, searched before all others; may be repeated");
}

void add_experiment_options(CLI::App& command, CommonOptions& options) {
  command.add_option("experiment", options.experiment, "Experiment file (TOML)")->required();
  command.add_option("--set", options.overrides,
                     "Override a key of the file: --set engine.step=0.0005; may be repeated");
  add_plugin_path_option(command, options);
}

void add_work_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--db", options.database,
                     "Database file (default: the experiment's name with .db, in this folder)");
  command.add_option("--threads", options.threads, "Threads (default: one a processor)")->check(CLI::Range(1, 1024));
  command.add_option("--seed", options.seed, "Seed, instead of the file's");
  command.add_option("--json", options.json, "Results as JSON, to standard output or FILE")
      ->expected(0, 1)
      ->default_str("");
  command.add_flag("--quiet", options.quiet, "Print results only");
}

}  // namespace lacuna
