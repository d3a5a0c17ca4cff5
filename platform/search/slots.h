#pragma once

#include "search/look.h"

namespace lacuna {

/// Whether one effect declares the other as hard to tell from it, or both are the same.
bool are_alike(const Hypothesis& one, const Hypothesis& other);

/// Whether both are at one place: the same element, or elements of two kinds, which may belong together.
bool same_place(const Hypothesis& one, const Hypothesis& other);

/// The most promising effects of a look: of those that look alike at a place none that promises much less than one
/// of no more values. None that looks like one of `beside`, which the model has.
std::vector<Promise> slots_of(const Look& look, const std::vector<EffectEntry>& beside, std::size_t most);

/// Numbers of the most promising hypotheses, without those that promise no more than a simpler one that looks like
/// them.
std::vector<std::size_t> not_redundant(const Look& look, std::size_t most);

}  // namespace lacuna
