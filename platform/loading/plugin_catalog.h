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
  std::string remark;   ///< a sentence about what it does and should not; empty: nothing
};

/// Every component of every plugin found on the search path, by kind and name. Components are
/// made at first use, live as long as the process, and are shared by threads. Calls to them that may
/// throw go through `guarded_call` with their `origin`.
class PluginCatalog {
 public:
  /// Loads all `*.so` files of the folders, in order of folder and name; a file that two of them lead
  /// to is loaded once. A folder that does not exist is passed over. Broken files do not hide the
  /// good ones: they are kept as `problems()`, and asking for a component that is missing names them.
  ///
  /// Then each component is made and asked what it is in a child process, with a time limit: one that ends the child,
  /// or takes too long, or changes the process (foundation/processes/process_watch.h), or says of itself what cannot be
  /// (loading/conformance.h), is refused with a sentence; the others go on working. The hooks of an effect are tried as
  /// well (loading/effect_probe.h).
  explicit PluginCatalog(const std::vector<std::filesystem::path>& folders);

  /// The component of that interface and name: `get<PhysicalEffect>("viscous_friction")`. Throws `Error` for a name
  /// that no plugin has, or that two have, for a component that was refused, and where making it fails.
  template <class Interface>
  const Interface& get(const std::string& name) const {
    return *static_cast<const Interface*>(shared_component(find(ComponentKind<Interface>::name, name)));
  }
  /// A new one, for kinds that have a state of their own, such as targets.
  template <class Interface>
  std::unique_ptr<Interface> make(const std::string& name) const {
    return std::unique_ptr<Interface>(
        static_cast<Interface*>(new_component(find(ComponentKind<Interface>::name, name))));
  }
  /// How messages name the component of that kind and name, whether it exists or not.
  template <class Interface>
  ComponentOrigin origin(const std::string& name) const {
    return origin(ComponentKind<Interface>::name, name);
  }

  /// Names of the usable components of a kind; none of them is made.
  template <class Interface>
  std::vector<std::string> names() const {
    return names(ComponentKind<Interface>::name);
  }

  /// What an effect does and should not, a sentence; empty: nothing is known.
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
  std::vector<std::shared_ptr<Entry>> entries_;  // shared: a component that was made outlives its catalog
  std::vector<std::string> problems_;
};

/// Where the program's own plugins lie: `../lib/lacuna/plugins` beside its folder; empty where the system
/// does not tell.
std::filesystem::path installed_plugins();

/// `--plugin-path` folders, then LACUNA_PLUGIN_PATH (colon-separated), then `../lib/lacuna/plugins`
/// beside the program's folder, which serves the installed tree and the build tree.
std::vector<std::filesystem::path> plugin_search_path(const std::vector<std::filesystem::path>& from_command_line);

}  // namespace lacuna
