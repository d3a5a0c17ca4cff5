#include "app/commands/commands.h"
#include "command_line/subcommands.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

void add_help_command(CLI::App& program) {
  auto words = std::make_shared<std::vector<std::string>>();  // shared: CLI11 keeps the callback, which must own them
  CLI::App* command = program.add_subcommand("help", "Show the help of a command");
  command->add_option("command", *words, "The command, such as compare or plugins list (default: all commands)")
      ->option_text("NAME ...");
  command->callback([&program, words] { std::fputs(help_text(program, *words).c_str(), stdout); });
}

}  // namespace lacuna
