#pragma once

#include <lacuna/plugin.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

struct PluginLoad;

/// A loaded plugin file. It stays in the process until the end, because code that may have thrown or may still be
/// called cannot be unloaded safely.
class PluginLibrary {
 public:
  /// Checks that the file is a complete library (elf_file.h), tries it in a child process (a damaged one would end this
  /// process), loads it with all symbols bound, and checks its table before any C++ of it is called. Throws `Error`:
  /// file, fault, what to do.
  static PluginLibrary load(const std::filesystem::path& file);
  /// For a program that carries out several commands: the current state of the process is the one that libraries must
  /// leave. Call it before a command, while no plugin is called.
  static void forget_process();
  /// The same for many files with one child process for all of them; throws none of their errors.
  static std::vector<PluginLoad> load_all(const std::vector<std::filesystem::path>& files);

  const std::filesystem::path& file() const { return file_; }
  const std::string& sha256() const { return sha256_; }
  const PluginTable& table() const { return *table_; }

 private:
  PluginLibrary() = default;
  static PluginLibrary open(const std::filesystem::path& file);

  std::filesystem::path file_;
  std::string sha256_;
  const PluginTable* table_ = nullptr;
};

/// The result for a file: a library, or a sentence with the reason.
struct PluginLoad {
  std::optional<PluginLibrary> library;
  std::string problem;
};

}  // namespace lacuna
