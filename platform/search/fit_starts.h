#pragma once

#include "search/effect_look.h"

namespace lacuna {

/// The values of a smaller model, with the missing ones near their neutral values: sizes at a fiftieth of their
/// distance in `with`, shapes as there. Values of hypotheses that were not examined are left out.
NamedValues slightly(const NamedValues& with, const NamedValues& without, const EffectLook& look);

/// The values of one set, plus those that only another set has.
NamedValues both_values(const NamedValues& other, const NamedValues& one);

}  // namespace lacuna
