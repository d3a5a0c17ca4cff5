#include "baselines/random_guess.h"

#include "plant/draw.h"

#include <algorithm>

namespace hidden_effects {

BaselineAnswer by_random_guess(const std::vector<Candidate>& candidates, std::uint64_t seed) {
  BaselineAnswer answer{"random", {}, candidates.empty() ? 0u : 1u, 0.0};
  Draw draw(seed, 0);
  for (const Candidate& candidate : candidates) answer.ranking.push_back(ranked(candidate, draw.uniform()));
  std::stable_sort(answer.ranking.begin(), answer.ranking.end(),
                   [](const RankedEffect& a, const RankedEffect& b) { return a.score > b.score; });
  return answer;
}

}  // namespace hidden_effects
