#pragma once

#include "config/toml/toml_node.h"

#include <string>

namespace lacuna {

/// Parses TOML 1.0. `file` is the name that locations carry. Throws `BadInput` with one located
/// problem where the text is not TOML, is longer than 4 MiB or nests too deep.
TomlNode parse_toml(const std::string& text, const std::string& file);

}  // namespace lacuna
