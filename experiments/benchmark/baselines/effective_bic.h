#pragma once

#include "baselines/candidate_fits.h"

namespace hidden_effects {

/// As how many independent rows those of a residual count: n / (1 + 2 Σρ), the autocorrelations ρ summed as long as
/// they are positive; no more than n. `parts` are stretches without a gap.
double effective_count(const std::vector<Eigen::VectorXd>& parts);

/// Bayes' information criterion of free-run fits (G. Schwarz, Ann. Statist. 6 (1978) 461-464), its n the effective
/// number of rows of the residual that the best fit leaves. Scores are half of the criterion's fall against the base,
/// in nats; an effect is there where the best score is above zero.
BaselineAnswer by_effective_bic(const BaseFit& base, const std::vector<Candidate>& candidates,
                                const std::vector<CandidateFit>& fits, const std::vector<std::size_t>& order);

}  // namespace hidden_effects
