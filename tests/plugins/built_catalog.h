#pragma once

#include "loading/plugin_catalog.h"

namespace lacuna {

/// The plugins of this build, as a user's program finds them.
inline const PluginCatalog& built_catalog() {
  static const PluginCatalog catalog(plugin_search_path({}));
  return catalog;
}

}  // namespace lacuna
