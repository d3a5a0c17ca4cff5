#pragma once

#include "config/toml/toml_node.h"

#include <string>
#include <vector>

namespace lacuna {

/// Puts `--set` overrides such as `engine.step=0.0005`, `model.effects[0].start.torque=1` or
/// `model.free."body.*.mass"=[1, 7]` into a file's tree, in their order. A value is TOML; what is
/// not TOML and has no quotes or brackets is taken as a text. Tables on the way are made where they
/// are missing, list items are not. Each that cannot be applied is a problem.
void apply_overrides(TomlNode& tree, const std::vector<std::string>& overrides, ProblemList& problems);

/// The key of an override as written: the text before its first `=`.
std::string overridden_key(const std::string& text);

}  // namespace lacuna
