#pragma once

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// A kind of component for which a plugin can be drafted.
struct DraftKind {
  std::string noun;  ///< as in `lacuna plugins list`, "robot format"
  std::string does;  ///< what the drafted component does, a clause
  std::string use;   ///< how an experiment names it, with @NAME@ instead of its name
};

/// All kinds but effects, which are drafted from formulas (formula/effect_source.h), by noun.
const std::vector<DraftKind>& draft_kinds();

/// The files of a plugin with one working component of a kind: text by file name. The plugin builds as a separate
/// project with the installed package or a build folder, and its test is `lacuna plugins check`. Formats get a sample
/// file, too. Throws `Error` for a kind that is not among `draft_kinds`.
std::map<std::string, std::string> plugin_draft(const std::string& noun, const std::string& name);

}  // namespace lacuna
