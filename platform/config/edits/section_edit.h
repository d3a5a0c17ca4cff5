#pragma once

#include "config/toml/toml_node.h"

#include <lacuna/effect_list.h>

#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// Edits of effects that stand as [[model.effects]], and of a [model] that has no list yet.
/// Nodes are those of the text's own tree.

/// The keys of an effect and their values as TOML, in the order in which they are written.
std::vector<std::pair<std::string, std::string>> keys_of(const EffectEntry& effect);

/// The text with a [[model.effects]] section behind `last`, the last one there is.
std::string with_section(const std::string& text, const TomlNode& last, const EffectEntry& effect);
/// The text without the section `effect` and the empty lines before it.
std::string without_section(const std::string& text, const TomlNode& effect);
/// The end of the last line of a section such as [model.free], comments behind it left out.
std::size_t end_of_section(const std::string& text, const TomlNode& section, const TomlNode& tree);
/// The text with `effects = [item]` as the last key of `model`, wherever that stands.
std::string with_effects_key(const std::string& text, const TomlNode& model, const TomlNode& tree,
                             const std::string& item);

}  // namespace lacuna
