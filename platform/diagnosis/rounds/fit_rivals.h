#pragma once

#include "diagnosis/rounds/round.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// Refits the hypotheses of a screened round that score best, from the best of their probes each, and judges them on
/// what was left out; the largest gain first. Those that are far behind after a few iterations go no further, and what
/// cannot be simulated is left out. Into `round.rivals`; where the time limit is reached, into `round.stopped` and
/// `round.not_examined`, too. `probes`: by hypothesis.
void fit_rivals(Round& round, const std::vector<std::vector<Probe>>& probes, std::uint64_t seed, int threads);

}  // namespace lacuna
