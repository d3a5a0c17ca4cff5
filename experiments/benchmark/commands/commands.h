#pragma once

namespace CLI {
class App;
}

namespace hidden_effects {

/// `lacuna-benchmark`, whole: returns the exit code (0 done, 1 failed, 2 bad input, 75 interrupted and to be run
/// again).
int run_program(int argc, char** argv);

/// One command each, with its options.
void add_plan_command(CLI::App& program);
void add_make_command(CLI::App& program);
void add_run_command(CLI::App& program);
void add_calibrate_command(CLI::App& program);
void add_figures_command(CLI::App& program);
void add_real_command(CLI::App& program);

}  // namespace hidden_effects
