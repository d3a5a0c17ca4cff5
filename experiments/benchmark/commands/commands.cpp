#include "commands/commands.h"

#include "command_line/usage_error.h"
#include "foundation/processes/interrupt.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>

namespace hidden_effects {
namespace {

enum ExitCode { kDone = 0, kFailed = 1, kBadInput = 2, kInterrupted = 75 };

int told(const std::exception& error, int code) {
  fmt::print(stderr, "lacuna-benchmark: {}\n", error.what());
  return code;
}

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App program("Measures what Lacuna finds in data whose missing effect is known", "lacuna-benchmark");
  program.require_subcommand(1);
  CLI::App* hidden = program.add_subcommand("hidden-effects", "Cases of which one or two effects are hidden, or none");
  hidden->require_subcommand(1);
  add_plan_command(*hidden);
  add_make_command(*hidden);
  add_run_command(*hidden);
  add_calibrate_command(*hidden);
  add_figures_command(*hidden);
  add_real_command(program);
  program.footer("Exit codes: 0 done, 1 failed, 2 bad input, 75 interrupted and to be run again.");
  lacuna::watch_for_interrupts();
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help) == 0 ? kDone : kFailed;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}\n", lacuna::usage_sentence(program, error, argc, argv));
    return kBadInput;
  } catch (const lacuna::Interrupted& error) {
    return told(error, kInterrupted);
  } catch (const std::invalid_argument& error) {
    return told(error, kBadInput);
  } catch (const std::exception& error) {
    return told(error, kFailed);
  }
  return kDone;
}

}  // namespace hidden_effects
