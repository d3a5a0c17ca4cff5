#include "loading/plugin_catalog.h"

#include <cstdlib>
#include <sstream>

namespace lacuna {

std::vector<std::filesystem::path> plugin_search_path(const std::vector<std::filesystem::path>& from_command_line) {
  std::vector<std::filesystem::path> folders = from_command_line;
  if (const char* variable = std::getenv("LACUNA_PLUGIN_PATH")) {
    std::istringstream list(variable);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) folders.emplace_back(folder);
  }
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (!unknown) folders.push_back(program.parent_path().parent_path() / "lib" / "lacuna" / "plugins");
  return folders;
}

}  // namespace lacuna
