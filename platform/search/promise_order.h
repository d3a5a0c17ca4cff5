#pragma once

#include "search/effect_look.h"

#include <set>
#include <string>
#include <vector>

namespace lacuna {

/// Price of a value, as a share of the whole gain, in the order in which sets are extended.
inline constexpr double kWorthOfAValue = 0.1;
/// Share of the best effect's predicted or reached gain; an effect with less is not followed up.
inline constexpr double kLeastShare = 0.1;

/// The effects that are worth a fit, by decreasing predicted gain less the price of their values, at most so many.
/// Leaves out those in `beside`, those with far less predicted gain than a simpler law of their kind, and all but one
/// of those that act alike.
std::vector<EffectPromise> best_promises(const EffectLook& look, const std::set<std::string>& beside, std::size_t most);

/// The other effects with the same predicted gain as a member ("coulomb_friction @ joint.hinge").
std::vector<EffectPromise> twins_of(const EffectLook& look, const std::string& member);

}  // namespace lacuna
