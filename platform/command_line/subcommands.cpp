#include "command_line/subcommands.h"

#include "foundation/text/problem.h"

#include <CLI/CLI.hpp>

namespace lacuna {

const CLI::App* find_subcommand(const CLI::App& command, const std::string& name) {
  for (const CLI::App* candidate : command.get_subcommands(nullptr))
    if (candidate->get_name() == name) return candidate;
  return nullptr;
}

std::vector<std::string> subcommand_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* candidate : command.get_subcommands(nullptr)) names.push_back(candidate->get_name());
  return names;
}

std::string help_text(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* command = &program;
  std::string name = program.get_name();
  for (const std::string& word : words) {
    const CLI::App* next = find_subcommand(*command, word);
    if (next == nullptr)
      throw_problem({}, name + ": there is no command \"" + word + "\"" +
                            did_you_mean(word, subcommand_names(*command)) + "; see " + name + " --help");
    command = next;
    name += " " + word;
  }
  // Not `App::help`, which of a command that is being carried out shows its own subcommand's.
  return command->get_formatter()->make_help(command, name, CLI::AppFormatMode::Normal);
}

}  // namespace lacuna
