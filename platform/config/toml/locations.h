#pragma once

#include "config/toml/toml_node.h"

#include <map>
#include <string>

namespace lacuna {

/// Where each key of a tree stands: "model.effects[0].where[1]" → place.
using Locations = std::map<std::string, SourceLocation>;
Locations locations_of(const TomlNode& tree);

/// Where `key` stands; where it does not, the nearest table or list around it, else `file`.
SourceLocation nearest_location(const Locations& locations, std::string key, const std::string& file);

}  // namespace lacuna
