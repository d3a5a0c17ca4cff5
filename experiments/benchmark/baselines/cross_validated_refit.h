#pragma once

#include "baselines/candidate_fits.h"

namespace hidden_effects {

/// Refits base and candidates without one trial after the other and predicts the one that was left out by free run;
/// where it starts is fitted to it, for nobody knows. Ranks by the RMS error there; scores are by what share it falls
/// below the base's. An effect is there where the squared error falls by more than a standard error over blocks of a
/// second (L. Breiman et al., Classification and Regression Trees, 1984, section 3.4.3: the one-standard-error rule).
BaselineAnswer by_cross_validated_refit(const Observed& seen, const BaseFit& base,
                                        const std::vector<Candidate>& candidates, const std::vector<CandidateFit>& fits,
                                        const std::vector<std::size_t>& order);

}  // namespace hidden_effects
