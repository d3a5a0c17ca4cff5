#pragma once

#include "command_line/option_tree.h"

#include <string>
#include <vector>

namespace lacuna {

/// What the shell offers where an option or argument is to be completed.
enum class Offered {
  nothing,
  files,
  folders,
  commands,  ///< of the program
  effects,   ///< names of effects, asked of the program
  plugins,   ///< names of all components, asked of the program
  kinds,     ///< of components, asked of the program
  rows,      ///< names of the views of a database and of its trials, asked of the program
  queries,   ///< statements on these views, asked of the program
  shells,    ///< that have a completion
};

/// The names of the shells that have a completion: bash, fish, zsh.
std::vector<std::string> completed_shells();

/// What is offered for an option of this command.
Offered offered_for(const CommandFacts& command, const OptionFacts& option);

/// The lines of the program that print what is asked of it, one name a line, for `sh` and its kin. The arguments of the
/// shell are the words of the command line so far.
std::string question_for(Offered offered);

/// A script for the shell that completes the program's commands, options and what these take. Throws `BadInput` for
/// another shell.
std::string completion_script(const std::string& shell, const std::vector<CommandFacts>& tree);

std::string bash_completion(const std::vector<CommandFacts>& tree);
std::string fish_completion(const std::vector<CommandFacts>& tree);
std::string zsh_completion(const std::vector<CommandFacts>& tree);

}  // namespace lacuna
