#pragma once

#include <filesystem>

namespace lacuna {

/// The folder with the plugins of this build.
inline std::filesystem::path built_plugins() {
  return std::filesystem::path(LACUNA_BINARY_DIRECTORY) / "lib" / "lacuna" / "plugins";
}

}  // namespace lacuna
