#pragma once

#include <lacuna/plugin.h>

#include <filesystem>
#include <memory>
#include <string>

namespace lacuna {

/// A loaded plugin file. It stays in the process until the end: unloading code that may have
/// thrown or may still be called is not survivable.
class PluginLibrary {
 public:
  /// Probes the file in a child process (a truncated one would end ours), loads it with all
  /// symbols bound, and checks its table before any C++ of it runs. Throws `Error`: file, what is
  /// wrong, what to do.
  static PluginLibrary load(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  const std::string& sha256() const { return sha256_; }
  const PluginTable& table() const { return *table_; }

 private:
  PluginLibrary() = default;
  std::filesystem::path file_;
  std::string sha256_;
  const PluginTable* table_ = nullptr;
};

}  // namespace lacuna
