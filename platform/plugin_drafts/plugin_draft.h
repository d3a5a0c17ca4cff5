#pragma once

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// A kind of component whose plugin can be drafted.
struct DraftKind {
  std::string noun;  ///< as `lacuna plugins list` calls it, "robot format"
  std::string does;  ///< what the drafted component does, a clause
  std::string use;   ///< how an experiment names it, @NAME@ in the place of its name
};

/// All kinds but effects, which are drafted from formulas (formula/effect_source.h), by noun.
const std::vector<DraftKind>& draft_kinds();

/// The files of a plugin with one component of a kind that works: text by file name. It builds in a project of its own
/// that finds the installed package or a build folder, and has a test, what `lacuna plugins check` tells. Of formats
/// there is a sample file as well. Throws `Error` for a kind that is not among `draft_kinds`.
std::map<std::string, std::string> plugin_draft(const std::string& noun, const std::string& name);

}  // namespace lacuna
