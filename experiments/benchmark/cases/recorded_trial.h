#pragma once

#include "cases/make_case.h"

#include <cstdint>

namespace hidden_effects {

/// Adds the random forces on the joints that a case has, if it has any; which follows from `seed`.
void add_random_forces(Excitation& excitation, const CaseNoise& noise, std::uint64_t seed);

/// Carries a trial out on the case's true plant, from rest at zero, and records it with the case's noise. `excitation`
/// has the true commands and no random forces; all that is random follows from `seed`. The trial has no name and is not
/// held out. Throws as `simulate` does.
MadeTrial recorded_trial(const MadeCase& made, const Excitation& excitation, std::uint64_t seed);

}  // namespace hidden_effects
