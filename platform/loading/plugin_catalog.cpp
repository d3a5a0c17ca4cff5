#include "loading/plugin_catalog.h"

namespace lacuna {

struct PluginCatalog::Entry {};
PluginCatalog::PluginCatalog(const std::vector<std::filesystem::path>&) {}
std::vector<std::filesystem::path> plugin_search_path(const std::vector<std::filesystem::path>& folders) {
  return folders;
}

}  // namespace lacuna
