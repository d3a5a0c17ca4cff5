#pragma once

#include <lacuna/plugin.h>

#include "loading/plugin_library.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// What `plugins list` shows of a component.
struct PluginListing {
  std::string kind;  ///< "physical_effect" ...
  std::string name;
  std::string summary;
  std::filesystem::path file;
  std::string sha256;
  std::string build_id;
};

/// Every component of every plugin found on the search path, by kind and name. Components are
/// made at first use, live as long as the process, and are shared by threads.
class PluginCatalog {
 public:
  /// Loads all `*.so` files of the folders, in order. A folder that does not exist is passed over
  ///. Broken files do not hide the good ones: they are kept as
  /// `problems()`, and asking for a component that is missing names them.
  explicit PluginCatalog(const std::vector<std::filesystem::path>& folders);

  const PhysicalEffect& effect(const std::string& name) const;
  const RobotDefinition& robot(const std::string& name) const;
  const FitnessMetric& metric(const std::string& name) const;
  /// Targets have a state of their own: a new one each time.
  std::unique_ptr<TargetSystem> make_target(const std::string& name) const;

  std::vector<PluginListing> list() const;
  /// Sentences about files that could not be used (broken, other version, duplicate names).
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  struct Entry;
  std::vector<std::shared_ptr<Entry>> entries_;
  std::vector<std::string> problems_;
};

/// `--plugin-path` folders, then LACUNA_PLUGIN_PATH (colon-separated), then the installed folder,
/// then the build folder beside the program.
std::vector<std::filesystem::path> plugin_search_path(const std::vector<std::filesystem::path>& from_command_line);

}  // namespace lacuna
