#pragma once

#include "baselines/answer.h"
#include "baselines/effect_signals.h"

namespace hidden_effects {

/// The naive way: which effect's change looks most like what the fitted base leaves? Ranks by the size of the
/// correlation. Something is missing where the best is too large for as many independent samples, at 5 % over all
/// that was tried (C. Bonferroni's bound): what the base absorbs and the noise's colour are not thought of.
BaselineAnswer by_residual_correlation(const std::vector<Candidate>& candidates,
                                       const std::vector<EffectSignal>& signals);

}  // namespace hidden_effects
