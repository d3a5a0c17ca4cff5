#pragma once

#include "loading/plugin_catalog.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// All that a component says about itself, as `plugins show` prints it.
struct ComponentDetails {
  PluginListing listing;
  ParameterDeclarations parameters;
  std::optional<EffectDescription> effect;  ///< of effects
};

/// The components of that name, of whatever kind. Throws `Error`: no such name (with the nearest one), or
/// a component that cannot say what it is.
std::vector<ComponentDetails> details_of(const PluginCatalog& catalog, const std::string& name);

/// `verbose`: with the file, its digest and its build.
std::string text_of(const ComponentDetails& details, bool verbose = false);
nlohmann::ordered_json json_of(const ComponentDetails& details);

}  // namespace lacuna
