#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "diagnosis/rounds/round.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lacuna {

inline constexpr double kFirstLevel = 0.05, kFurtherLevel = 0.01;  ///< of chance: the first effect, those after it

/// The rival of a round to go on with: the screening's best score is beyond chance at `level`, or it surely explains a
/// part of what a force of any form shows to be there; it predicts what
/// was left out better than the base by half a nat, and of those within one standard error of the best, or a tenth of
/// its gain, it is the simplest; a still simpler one goes first if it has half of the best gain, since the next round
/// may find that it and another one do as well (rejudge.h). An effect of a sensor goes first only where the data tell
/// it from those of the rig. Nothing: none of them.
std::optional<std::size_t> choose(const Round& round, double level);

inline constexpr std::size_t kMostLookAlikes = 6;

/// Rivals that these data do not tell from the chosen one, the best first, at most `kMostLookAlikes`.
std::vector<std::size_t> inseparable(const Round& round, std::size_t chosen, std::uint64_t seed);

/// Added effects with values and intervals; `fit`: of the model that has them.
std::vector<FoundEffect> found_effects(const std::vector<EffectEntry>& added, const ModelDefinition& definition,
                                       const Refit& fit);

/// A model's own free values with intervals, by address: all but those of added effects.
std::vector<FoundParameter> own_values(const std::vector<EffectEntry>& added, const ModelDefinition& definition,
                                       const Refit& fit);

/// Gains of two steps, one after the other.
Gain sum(const Gain& a, const Gain& b);

/// Sets the probabilities of verdict and ranking, as if held-out likelihoods were calibrated ("uncalibrated").
void weigh(Diagnosis& diagnosis);

}  // namespace lacuna
