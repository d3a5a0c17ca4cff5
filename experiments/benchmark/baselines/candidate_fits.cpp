#include "baselines/candidate_fits.h"

#include <algorithm>
#include <numeric>

namespace hidden_effects {
namespace {

constexpr std::size_t kStarts = 2;                      ///< of each fit
constexpr double kLeastScale = 0.1, kMostScale = 10.0;  ///< of a try's size

/// The candidate's signals, the most likely first.
std::vector<const EffectSignal*> likely(std::size_t candidate, const std::vector<EffectSignal>& signals) {
  std::vector<const EffectSignal*> own;
  for (const EffectSignal& signal : signals)
    if (signal.candidate == candidate && signal.change.size() > 0) own.push_back(&signal);
  std::stable_sort(own.begin(), own.end(),
                   [](const EffectSignal* a, const EffectSignal* b) { return a->partial > b->partial; });
  return own;
}

}  // namespace

std::vector<std::size_t> by_partial_correlation(std::size_t candidates, const std::vector<EffectSignal>& signals) {
  std::vector<double> best(candidates, -1.0);
  for (const EffectSignal& signal : signals) best[signal.candidate] = std::max(best[signal.candidate], signal.partial);
  std::vector<std::size_t> order(candidates);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return best[a] > best[b]; });
  return order;
}

std::vector<CandidateFit> fit_candidates(const Observed& seen, const BaseFit& base,
                                         const std::vector<Candidate>& candidates,
                                         const std::vector<EffectSignal>& signals,
                                         const std::vector<std::size_t>& order, std::size_t most) {
  std::vector<CandidateFit> fits;
  for (std::size_t k = 0; k < std::min(most, order.size()); ++k) {
    const Candidate& candidate = candidates[order[k]];
    CandidateFit best{order[k], with_law(seen.base, candidate.law), {}};
    const std::vector<const EffectSignal*> starts = likely(order[k], signals);
    for (std::size_t s = 0; s < std::min(kStarts, starts.size()); ++s) {
      const Try& from = starts[s]->tried;
      const double size = from.size * std::clamp(starts[s]->scale, kLeastScale, kMostScale);
      PlantFit fit =
          fit_plant(best.model, seen.trials, with_parameters(base.fit.values, candidate.at_size(size, from.shape)),
                    base.fit.starts, by_deviation(base.deviations));
      if (fit.valid && (!best.fit.valid || fit.deviance < best.fit.deviance)) best.fit = std::move(fit);
    }
    if (best.fit.valid) fits.push_back(std::move(best));
  }
  return fits;
}

std::vector<RankedEffect> rank_fitted(const std::vector<Candidate>& candidates, const std::vector<CandidateFit>& fits,
                                      const std::vector<double>& scores, const std::vector<std::size_t>& order) {
  std::vector<RankedEffect> ranking;
  std::vector<bool> is_fitted(candidates.size(), false);
  for (std::size_t k = 0; k < fits.size(); ++k) {
    ranking.push_back(ranked(candidates[fits[k].candidate], scores[k]));
    is_fitted[fits[k].candidate] = true;
  }
  std::stable_sort(ranking.begin(), ranking.end(),
                   [](const RankedEffect& a, const RankedEffect& b) { return a.score > b.score; });
  double below = ranking.empty() ? 0.0 : std::min(0.0, ranking.back().score);
  for (const std::size_t c : order)
    if (!is_fitted[c]) ranking.push_back(ranked(candidates[c], below -= 1.0));
  return ranking;
}

}  // namespace hidden_effects
