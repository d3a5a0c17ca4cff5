#pragma once

#include "dirty/effect_size.h"

#include <vector>

namespace hidden_effects::dirty {

inline constexpr double kLeastMain = 1.5;  ///< of the noise: a main effect that leaves less is none

/// Draws what a case hides: main effects that leave the plan's strength or what comes nearest to it, then wrong values
/// of the robot file, small laws and an error of a sensor round them, each of which alone leaves a tenth of the main
/// ones' error at most. Throws `std::runtime_error` where no main effect comes out.
std::vector<DirtyEffect> choose_effects(const DirtyPlan& plan, const DirtyRig& rig, const SizingBench& bench,
                                        RigDraw& draw);

}  // namespace hidden_effects::dirty
