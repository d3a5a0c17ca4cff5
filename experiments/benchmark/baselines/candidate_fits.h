#pragma once

#include "baselines/answer.h"
#include "baselines/effect_signals.h"

namespace hidden_effects {

/// Base and one law, fitted together by free run over all trials.
struct CandidateFit {
  std::size_t candidate = 0;
  PlantModel model;
  PlantFit fit;
};

/// The candidates, those first whose change, with what the base can do projected out, is most like what the base
/// leaves. Only the sign that physics allows counts: laws of either sign are tried with both.
std::vector<std::size_t> by_partial_correlation(std::size_t candidates, const std::vector<EffectSignal>& signals);

/// Fits the first `most` of `order`, each from its most likely tries, of the size that the screening tells.
std::vector<CandidateFit> fit_candidates(const Observed& seen, const BaseFit& base,
                                         const std::vector<Candidate>& candidates,
                                         const std::vector<EffectSignal>& signals,
                                         const std::vector<std::size_t>& order, std::size_t most);

/// The fitted ones by their scores, best first, then the others in the order of the screening with scores below.
std::vector<RankedEffect> rank_fitted(const std::vector<Candidate>& candidates, const std::vector<CandidateFit>& fits,
                                      const std::vector<double>& scores, const std::vector<std::size_t>& order);

}  // namespace hidden_effects
