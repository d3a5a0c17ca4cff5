#include "command_line/subcommands.h"

#include "foundation/text/problem.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string_view>

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

std::optional<std::vector<std::string>> command_to_explain(const CLI::App& program, int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, std::find(argv + 1, argv + argc, std::string_view("--")));
  const auto asks = [](const std::string& word) { return word == "--help" || word == "-h"; };
  if (std::none_of(words.begin(), words.end(), asks)) return std::nullopt;
  const CLI::App* command = &program;
  std::vector<std::string> names;
  for (const std::string& word : words) {
    if (word.starts_with('-')) continue;
    if (command->get_subcommands(nullptr).empty()) break;  // what follows are its files
    command = find_subcommand(*command, word);
    if (command == nullptr) return std::nullopt;
    names.push_back(word);
  }
  return names;
}

}  // namespace lacuna
