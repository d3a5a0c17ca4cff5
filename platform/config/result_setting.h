#pragma once

#include "config/toml/toml_node.h"

#include <string>
#include <vector>

namespace lacuna {

/// What the results of an experiment follow from: the tree of its file with what `--set` puts beside it, but without
/// `sweep` and how a target's program is run, all keys of a process target but `version`. Throws `BadInput` where the
/// text is no TOML.
TomlNode result_setting(const std::string& text, const std::vector<std::string>& overrides);

/// Whether two settings have targets of one kind and, where they are programs, of one `version`.
bool same_target(const TomlNode& a, const TomlNode& b);

}  // namespace lacuna
