#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/rounds/round.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What the effects that an experiment's model has already explain.
struct PresentEffects {
  std::vector<std::string> names;  ///< "name @ where"
  Gain gain;                       ///< of all together over the model without them, under the noise of a round
};

/// Nothing where the model has none, or cannot be simulated without them.
std::optional<PresentEffects> present_effects(const Contender& plain, const PluginCatalog& catalog, const Round& round,
                                              std::uint64_t seed, int threads);

/// What could still be gained is so little beside what the effects that are there explain that it more likely makes up
/// for the form of one of them (a real friction is never quite the library's), while the model is at the floor without
/// it.
inline constexpr double kFormShare = 0.05;   ///< of what the effects explain
inline constexpr double kFormAtFloor = 1.4;  ///< times the floor

}  // namespace lacuna
