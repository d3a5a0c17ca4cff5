#include "diagnosis/rounds/deeper_minimum.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr std::size_t kAsked = 2;   ///< rivals, the largest gain first
constexpr double kClearly = 10.0;   ///< of the deviance
constexpr double kOfTheGain = 0.3;  ///< what an effect does is not done by the values beside it
constexpr int kSoonShown = 4;       ///< iterations of the refit

Refit from_rival(const Contender& model, const Round& round, const Rival& rival, int threads) {
  Contender there = model;
  const std::vector<std::size_t>& places = round.hypotheses[rival.hypothesis].base;
  for (std::size_t i = 0; i < there.values.size(); ++i) there.values[i] = rival.fit.values[places[i]];
  const BaseSolution base = from(without_values(round.base), rival.fit);
  return refit({there.definition, *there.model, {}}, base, round.bins, round.factors, {there.values}, threads,
               {RefitEffort().precision, kSoonShown});
}

}  // namespace

std::optional<Refit> deeper_minimum(const Contender& model, const Round& round, int threads) {
  std::optional<Refit> deepest;
  for (std::size_t i = 0; i < std::min(kAsked, round.rivals.size()); ++i) {
    const Rival& rival = round.rivals[i];
    const double explained = round.fit.deviance - rival.fit.deviance;
    if (explained < kClearly) continue;
    Refit found = from_rival(model, round, rival, threads);
    if (!found.valid || round.fit.deviance - found.deviance < std::max(kClearly, kOfTheGain * explained)) continue;
    if (!deepest || found.deviance < deepest->deviance) deepest = std::move(found);
  }
  return deepest;
}

}  // namespace lacuna
