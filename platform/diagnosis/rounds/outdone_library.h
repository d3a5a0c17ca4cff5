#pragma once

#include "diagnosis/rounds/round.h"

#include <cstddef>
#include <cstdint>

namespace lacuna {

/// Whether the formula that a round proposes predicts better than every single effect that was refitted, beyond the
/// interval of the difference.
bool law_leads(const Round& round, std::uint64_t seed);

/// Whether a law that leads, the first of the model without any effect, outdoes the library: no model of `round` (its
/// own, with `added` effects, and those with one more) predicts better, the model has as many effects as the law has
/// terms, and structure is left. Then the library only imitates the law, and longer models would, too; a law that
/// imitated two effects itself would lose to these two. `before`: the model's gain over the one without any effect.
bool outdoes_library(const ForceFormula& law, const Round& round, std::size_t added, const Gain& before);

/// By how many nats the law predicts better than the best of these models.
double lead_of(const ForceFormula& law, const Round& round, const Gain& before);

}  // namespace lacuna
