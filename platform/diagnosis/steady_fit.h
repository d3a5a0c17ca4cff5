#pragma once

#include "diagnosis/round.h"

#include <vector>

namespace lacuna {

/// The fit of a round's model once more, with the integrator's error taken off `measured`, the trials of `last` as they
/// were recorded, where the values stand, until they stay: a round takes it off where they began, and a resonance is
/// damped by coarse steps as much as by itself. `last.fit` where nothing better can be had: from steps that an impact
/// in a gap is over in no limit can be told, and what is left grows. Its covariance is the wary one (jackknife.h).
Refit steady_fit(const Contender& model, const Round& last, const std::vector<Trial>& measured, int threads);

}  // namespace lacuna
