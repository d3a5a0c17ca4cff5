#pragma once

#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// What became of a case whose main effect is a force.
struct ForceVerdict {
  bool withheld = false;   ///< the library was not to have the effect
  bool disturbed = false;  ///< random forces acted, too
  bool ended = false;      ///< the verdict is `not_in_library`
  bool told = false;       ///< a force that no effect has is told, in the verdict or beside it
  bool named = false;      ///< what that force goes with is what the main effect goes with (dirty/dirty_kind.h)
};
ForceVerdict force_verdict_of(const CaseResult& result);

/// Markdown: how many withheld laws are recognised, as a remainder or by the verdict, and of how many of them it is
/// named what they go with; how often the library is said to end where it has the law. Then a case a row.
std::string withheld_tables(const std::vector<CaseResult>& results);

}  // namespace hidden_effects
