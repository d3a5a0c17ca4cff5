#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace lacuna {

/// What an option or an argument takes.
enum class OptionValue {
  none,           ///< a flag
  text,           ///< anything else
  whole_number,   ///< as --threads N
  number,         ///< as --most-megabytes MB
  file,           ///< the name of a file
  folder,         ///< the name of a folder
  optional_file,  ///< --json, or --json=FILE
};

/// An option, or an argument without a name before it, as the help shows it.
struct OptionFacts {
  std::string name;  ///< of an option without its hyphens: "plugin-path"
  std::string text;  ///< what stands for the value in the help: "FOLDER"
  std::string description;
  OptionValue value = OptionValue::text;
  bool positional = false;
  bool required = false;
  bool repeats = false;     ///< takes several values, with the option before each
  bool takes_rest = false;  ///< and also one after the other, up to the next option
};

/// A command that does something, or that others stand below.
struct CommandFacts {
  std::vector<std::string> words;  ///< "plugins", "list"; of the program itself none
  std::string description;
  std::vector<OptionFacts> options;      ///< arguments without a name included, these in their order
  std::vector<std::string> subcommands;  ///< their names
};

/// The program and all of its commands, each before those below it. From the declarations that also parse the command
/// line, so that help, completion, manual pages and tools for agents say the same.
std::vector<CommandFacts> option_tree(const CLI::App& program);

/// Whether a command stands directly below another one.
bool stands_below(const CommandFacts& below, const CommandFacts& command);

}  // namespace lacuna
