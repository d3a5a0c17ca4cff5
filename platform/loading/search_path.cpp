#include "loading/plugin_catalog.h"

#include "foundation/files/allowed_files.h"

#include <cstdlib>
#include <sstream>

namespace lacuna {

std::filesystem::path installed_plugins() {
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  return program.empty() ? program : program.parent_path().parent_path() / "lib" / "lacuna" / "plugins";
}

std::vector<std::filesystem::path> plugin_search_path(const std::vector<std::filesystem::path>& from_command_line) {
  for (const std::filesystem::path& folder : from_command_line) check_may_read(folder);
  std::vector<std::filesystem::path> folders = from_command_line;
  if (const char* variable = std::getenv("LACUNA_PLUGIN_PATH")) {
    std::istringstream list(variable);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) folders.emplace_back(folder);
  }
  if (const std::filesystem::path installed = installed_plugins(); !installed.empty()) folders.push_back(installed);
  return folders;
}

}  // namespace lacuna
