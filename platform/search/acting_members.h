#pragma once

#include "search/effect_look.h"
#include "search/fitted_models.h"

#include <set>
#include <string>

namespace lacuna {

/// Whether the data tell that a member of a fitted set acts: the 95 % interval of one of its sizes, at one of its
/// places, excludes the value at which the effect does nothing. Sizes are the parameters that change predictions by
/// themselves; a period or a rest position is none.
bool acts(const EffectEntry& member, const FittedModel& set, const CellLayout& layout, const EffectLook& look);

/// The members that may do nothing, "effect @ place": the intervals of all their sizes include that value. One whose
/// value the data do not tell at all, as that of a friction that holds a joint at rest, is none of them.
std::set<std::string> idle_members(const FittedModel& set, const CellLayout& layout, const EffectLook& look);

}  // namespace lacuna
