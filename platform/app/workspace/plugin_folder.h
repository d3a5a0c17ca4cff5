#pragma once

#include "foundation/text/problem.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// A plugin that is about to be written.
struct NewPlugin {
  std::string kind;  ///< as `plugins list` calls it, "robot format"
  std::string name;
  std::filesystem::path into = ".";
  std::vector<std::filesystem::path> plugin_paths;  ///< where its name must be new
};

/// Adds what keeps a plugin from having that name: letters, names that CMake or this program has taken, a component of
/// the same kind and name.
void check_plugin_name(const NewPlugin& plugin, ProblemList& problems);

/// Writes the files, text by name, into a folder of the plugin's name, which must not exist: nothing of a user's is
/// overwritten. Returns the folder. Throws `BadInput`.
std::filesystem::path write_plugin_folder(const NewPlugin& plugin, const std::map<std::string, std::string>& files);

/// Prints how the folder is built and tested, then `use`, a line on what comes next, with @PATH@ in the place of the
/// option that lets a command find the plugin.
void print_next_steps(const std::filesystem::path& folder, const std::string& use);

}  // namespace lacuna
