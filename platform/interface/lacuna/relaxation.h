#pragma once

#include <cmath>

namespace lacuna {

/// Exact solution of dz/dt = input − decay·z over a step with constant input and decay: z after = carried·z +
/// gained·input, mean of z over the step = mean_carried·z + mean_gained·input.
struct Relaxation {
  double carried = 1.0, gained = 0.0;            ///< 1, s
  double mean_carried = 1.0, mean_gained = 0.0;  ///< 1, s

  /// `decay`: ≥ 0, 1/s; `step`: s.
  Relaxation(double decay, double step) {
    const double x = decay * step;
    carried = std::exp(-x);
    mean_carried = x < 1e-8 ? 1.0 - 0.5 * x : -std::expm1(-x) / x;
    gained = step * mean_carried;
    mean_gained = step * (x < 1e-3 ? 0.5 - x / 6.0 + x * x / 24.0 : (1.0 - mean_carried) / x);
  }
};

/// The share of a step at which an oscillation's forces are evaluated so that it keeps its amplitude where the step
/// resolves it, and decays without alternating where not. `angle`: angular frequency times step, rad.
inline double share_of_step(double angle) { return angle * angle > 0.5 ? 1.0 - 0.25 / (angle * angle) : 0.5; }

}  // namespace lacuna
