#include "app/commands/commands.h"
#include "command_line/completion.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <memory>
#include <string>

namespace lacuna {

void add_completion_command(CLI::App& program) {
  auto shell = std::make_shared<std::string>();  // shared: CLI11 keeps the callback, which must own it
  CLI::App* command = program.add_subcommand(
      "completion", "Print a script for shell completion; load it with, for example, source <(lacuna completion bash)");
  command->add_option("shell", *shell, fmt::format("{}", fmt::join(completed_shells(), ", ")))
      ->required()
      ->option_text("SHELL");
  command->callback([&program, shell] { std::fputs(completion_script(*shell, option_tree(program)).c_str(), stdout); });
}

}  // namespace lacuna
