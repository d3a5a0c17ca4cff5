#pragma once

#include <algorithm>

namespace lacuna::articulated {

/// The time within a step of length h at which the forces of springs and dampers are evaluated. Motions that the step
/// resolves use its middle, which is of second order and keeps the amplitude of an oscillation. Others use a later
/// time, up to its end, so that they decay within a few steps and never alternate.

/// A damper of a rate damping·mobility (1/s): its velocity is (1 − late)·before + late·after.
/// The factor (1 − (1 − late)·z)/(1 + late·z) by which a step changes a velocity, z = rate·h, stays positive.
inline double late_damping(double rate_times_step) { return rate_times_step > 2.0 ? 1.0 - 1.0 / rate_times_step : 0.5; }

/// A spring: the distance from the middle of the step at which its position is evaluated, before·h·v + after·h·v'.
struct SpringWeights {
  double before = -0.25, after = 0.25;
};

/// Resolved up to ω·h = 1/2. With 1 − s = min(1, 1/(4·(ω·h)²)), before = −(1 − s)/4 and after = (1 + 3·s)/4 the sum of
/// the two factors of an undamped oscillation, 2 − (ω·h)²·(1 − s)/2 over a positive number, stays positive, and their
/// product falls to zero.
inline SpringWeights spring_weights(double frequency_times_step_squared) {
  const double resolved = std::min(1.0, 0.25 / std::max(frequency_times_step_squared, 1e-300));
  return {.before = -0.25 * resolved, .after = 1.0 - 0.75 * resolved};
}

}  // namespace lacuna::articulated
