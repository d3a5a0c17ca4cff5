#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace lacuna {

/// The command of that name directly below another; null where there is none.
const CLI::App* find_subcommand(const CLI::App& command, const std::string& name);

std::vector<std::string> subcommand_names(const CLI::App& command);

/// The help of the command that `words` name from the program on, `{"plugins", "list"}`; of the program without words.
/// The same as that command's `--help` prints. Throws `BadInput` for a word that names no command, with the nearest
/// name.
std::string help_text(const CLI::App& program, const std::vector<std::string>& words);

/// The command whose help a command line asks for, wherever --help or -h stands in it, in words as for `help_text`;
/// nothing where it asks for none, or where a word that should name a command names none. So a file that would be
/// refused does not stand between a user and the help.
std::optional<std::vector<std::string>> command_to_explain(const CLI::App& program, int argc, char** argv);

}  // namespace lacuna
