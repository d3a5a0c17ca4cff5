#pragma once

#include "loading/built_plugins.h"
#include "support/test_folder.h"

#include <filesystem>
#include <string>

namespace lacuna {

/// The library of that name as CMake built it.
inline std::filesystem::path bad_plugin(const std::string& name) {
  return std::filesystem::path(LACUNA_BINARY_DIRECTORY) / "tests" / "bad_plugins" / (name + ".so");
}

/// A plugin folder with that library alone.
class BadFolder : public TestFolder {
 public:
  explicit BadFolder(const std::string& name) { std::filesystem::copy_file(bad_plugin(name), path() / (name + ".so")); }
};

}  // namespace lacuna
