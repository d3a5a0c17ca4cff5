#include "baselines/residual_correlation.h"

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kLevel = 0.05;

/// That a normal deviate is larger than this in size, either way.
double two_sided(double deviate) { return std::erfc(deviate / std::sqrt(2.0)); }

}  // namespace

BaselineAnswer by_residual_correlation(const std::vector<Candidate>& candidates,
                                       const std::vector<EffectSignal>& signals) {
  std::vector<double> best(candidates.size(), 0.0);
  double rows = 1.0;
  for (const EffectSignal& signal : signals) {
    best[signal.candidate] = std::max(best[signal.candidate], std::abs(signal.correlation));
    rows = std::max(rows, static_cast<double>(signal.change.size()));
  }
  BaselineAnswer answer{"residual_correlation", {}, 0, 0.0};
  for (std::size_t c = 0; c < candidates.size(); ++c) answer.ranking.push_back(ranked(candidates[c], best[c]));
  std::stable_sort(answer.ranking.begin(), answer.ranking.end(),
                   [](const RankedEffect& a, const RankedEffect& b) { return a.score > b.score; });
  const double deviate = answer.ranking.empty() ? 0.0 : answer.ranking.front().score * std::sqrt(rows);
  answer.chosen = two_sided(deviate) * static_cast<double>(signals.size()) < kLevel ? 1 : 0;
  return answer;
}

}  // namespace hidden_effects
