#pragma once

#include <lacuna/plugin.h>

#include "foundation/processes/guarded_call.h"
#include "loading/plugin_library.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// What `plugins list` shows of a component.
struct PluginListing {
  std::string kind;  ///< as users call it: "effect", "robot", "test fitness"; see `ComponentKind`
  std::string name;
  std::string summary;
  std::filesystem::path file;
  std::string sha256;
  std::string build_id;
  std::string problem;  ///< why it cannot be used; empty: it can
  std::string remark;   ///< a fault that does not change results, a sentence; empty: none
};

/// Every component of every plugin on the search path, by kind and name. Components are made at first use, live as long
/// as the process, and are shared by threads. Calls to them that may throw must go through `guarded_call` with their
/// `origin`.
class PluginCatalog {
 public:
  /// Loads all `*.so` files of the folders, in order of folder and name; a file reached through two of them is loaded
  /// once. A missing folder is skipped. Broken files do not hide the good ones: they are kept as `problems()`, which
  /// are listed when a component is missing.
  ///
  /// Then each component is made and described in a child process with a time limit. One that ends the child, takes too
  /// long, changes the process (foundation/processes/process_watch.h), or has an invalid description
  /// (loading/conformance.h) is refused with a sentence; the others stay usable. The hooks of an effect are tried, too
  /// (loading/effect_probe.h).
  explicit PluginCatalog(const std::vector<std::filesystem::path>& folders);

  /// The component of that interface and name: `get<PhysicalEffect>("viscous_friction")`. Throws `Error` for a name
  /// without a plugin, or with two, for a component that was refused, and where making it fails.
  template <class Interface>
  const Interface& get(const std::string& name) const {
    return *static_cast<const Interface*>(shared_component(find(ComponentKind<Interface>::name, name)));
  }
  /// A new object, for kinds with state, such as targets.
  template <class Interface>
  std::unique_ptr<Interface> make(const std::string& name) const {
    return std::unique_ptr<Interface>(
        static_cast<Interface*>(new_component(find(ComponentKind<Interface>::name, name))));
  }
  /// The name of the component in messages, whether it exists or not.
  template <class Interface>
  ComponentOrigin origin(const std::string& name) const {
    return origin(ComponentKind<Interface>::name, name);
  }

  /// Names of the usable components of a kind; makes none of them.
  template <class Interface>
  std::vector<std::string> names() const {
    return names(ComponentKind<Interface>::name);
  }

  /// A fault of an effect that does not change results, a sentence; empty: none is known.
  std::string remark_on_effect(const std::string& name) const;

  /// Every component, by kind and name, with its summary.
  std::vector<PluginListing> list() const;
  /// Sentences about files that could not be used (broken, other version) and names that two plugins have.
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  struct Entry;

  void add(const PluginLibrary& library);
  void refuse_unfit();
  void refuse_library(const std::string& file, const std::string& death);
  static std::string rehearse(const Entry& entry);
  void find_duplicates();
  ComponentOrigin origin(std::string_view kind, const std::string& name) const;
  std::vector<std::string> names(std::string_view kind) const;
  const std::shared_ptr<Entry>& find(std::string_view kind, const std::string& name) const;
  std::string missing(std::string_view kind, const std::string& name) const;
  static void* shared_component(const std::shared_ptr<Entry>& entry);
  static void* new_component(const std::shared_ptr<Entry>& entry);

  std::vector<std::filesystem::path> folders_;
  std::vector<std::shared_ptr<Entry>> entries_;  // shared: a component may outlive its catalog
  std::vector<std::string> problems_;
};

/// The folder of the program's own plugins: `../lib/lacuna/plugins` beside its folder; empty where the system does not
/// give it.
std::filesystem::path installed_plugins();

/// `--plugin-path` folders, then LACUNA_PLUGIN_PATH (colon-separated), then `../lib/lacuna/plugins`
/// beside the program's folder, which serves the installed tree and the build tree.
std::vector<std::filesystem::path> plugin_search_path(const std::vector<std::filesystem::path>& from_command_line);

}  // namespace lacuna
