#pragma once

#include "command_line/option_tree.h"

#include <string>

namespace lacuna {

/// What a manual page says beyond the option tree.
struct ManualFrame {
  std::string version;  ///< of the program
  std::string notes;    ///< of the program's own page: paragraphs after its commands
};

/// "lacuna-plugins-list", the name of a command's manual page in section 1.
std::string manual_name(const CommandFacts& command);

/// The manual page of a command, in the man macros of roff.
std::string manual_page(const CommandFacts& command, const std::vector<CommandFacts>& tree, const ManualFrame& frame);

}  // namespace lacuna
