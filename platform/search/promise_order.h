#pragma once

#include "search/effect_look.h"

#include <set>
#include <string>
#include <vector>

namespace lacuna {

/// Of the whole gain, what a value is worth in the order in which sets lead to larger ones.
inline constexpr double kWorthOfAValue = 0.1;
/// Of what the best effect promises, or gains: less is not followed.
inline constexpr double kLeastShare = 0.1;

/// Of the effects of a look those that are worth a fit, the most promising first, less what their values are worth: at
/// most so many. None of `beside`, none that a simpler law of its kind outdoes by far, one of those that promise the
/// same.
std::vector<EffectPromise> best_promises(const EffectLook& look, const std::set<std::string>& beside, std::size_t most);

/// The other effects that promise the same as a member ("coulomb_friction @ joint.hinge").
std::vector<EffectPromise> twins_of(const EffectLook& look, const std::string& member);

}  // namespace lacuna
