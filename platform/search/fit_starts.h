#pragma once

#include "search/effect_look.h"

namespace lacuna {

/// The values of a model that has less, with those that it lacks near where they change nothing: sizes at a fiftieth of
/// their way in `with`, shapes as there. Values that no hypothesis of the look has are not taken over.
NamedValues slightly(const NamedValues& with, const NamedValues& without, const EffectLook& look);

/// The values of one set, and of another what the first does not have.
NamedValues both_values(const NamedValues& other, const NamedValues& one);

}  // namespace lacuna
