#pragma once

#include "command_line/option_tree.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace lacuna {

/// A command of the program as a tool of the Model Context Protocol.
struct Tool {
  std::string name;                  ///< "plugins_list"
  std::string title;                 ///< "lacuna plugins list"
  std::string description;           ///< what it does and when an agent calls it
  std::vector<std::string> words;    ///< the command
  std::vector<OptionFacts> options;  ///< those that an agent may give, as the command line has them
  bool reads_only = false;           ///< it changes no file of the folder
  bool has_json = false;             ///< the command has --json
};

/// An option's name among a tool's arguments: "plugin_path".
std::string argument_name(const OptionFacts& option);

/// The commands that an agent may call, of those that the program has.
std::vector<Tool> tools_of(const std::vector<CommandFacts>& tree);

/// The tool as `tools/list` has it.
nlohmann::ordered_json tool_json(const Tool& tool);

}  // namespace lacuna
