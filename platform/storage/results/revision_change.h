#pragma once

#include "storage/core/records.h"

#include <string>

namespace lacuna {

/// What a revision has that its parent had not.
struct RevisionChange {
  EffectList added;
  EffectList removed;
  std::string sentence;  ///< "rigid", "coulomb_friction", "without payload", "other engine, fit data"
};

RevisionChange change_of_first(const RevisionRecord& revision);
/// Effects are the same if name, place and id are; other values of the same effect are a change.
RevisionChange change_between(const RevisionRecord& parent, const RevisionRecord& revision);

}  // namespace lacuna
