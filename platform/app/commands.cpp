#include "app/commands.h"

#include "app/options.h"

#include "foundation/interrupt.h"
#include "foundation/problem.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace lacuna {
namespace {

constexpr int kFailed = 1;
constexpr int kBadInput = 2;
constexpr int kInterrupted = 75;

int complain(const std::exception& error, int code) {
  std::fflush(stdout);
  std::fprintf(stderr, "%s\n", error.what());
  return code;
}

/// CLI11 would only say that a command is missing.
void refuse_unknown_command(const CLI::App& program, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "-";
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) names.push_back(command->get_name());
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw BadInput({{{}, "there is no command \"" + word + "\"" + did_you_mean(word, names) + "; see lacuna --help"}});
}

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App program("Finds what a robot model is missing.", "lacuna");
  program.require_subcommand(1);
  program.set_version_flag("--version", std::string(LACUNA_VERSION));
  add_check_command(program);
  add_new_command(program);
  add_fit_command(program);
  add_compare_command(program);
  add_add_command(program);
  add_undo_command(program);
  add_history_command(program);
  add_plugins_command(program);
  add_sql_command(program);

  set_command_line(argc, argv);
  watch_for_interrupts();
  try {
    refuse_unknown_command(program, argc, argv);
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& help_or_version) {
    return program.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    program.exit(error);
    return kBadInput;
  } catch (const BadInput& error) {
    return complain(error, kBadInput);
  } catch (const Interrupted& error) {
    return complain(error, kInterrupted);
  } catch (const std::exception& error) {
    return complain(error, kFailed);
  }
}

}  // namespace lacuna
