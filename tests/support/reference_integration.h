#pragma once

#include <functional>
#include <vector>

/// Solutions of equations of motion that owe nothing to the simulator: the tests' second opinion.
namespace lacuna {

using ReferenceState = std::vector<double>;

/// Writes the time derivative of a state: (state, derivative, time in s).
using Derivative = std::function<void(const ReferenceState&, ReferenceState&, double)>;

/// States at `times` (ascending) of a smooth system that is at `start` at `times.front()`.
/// Runge–Kutta–Fehlberg 7(8) of Boost.odeint with a local error of `kReferenceTolerance`.
std::vector<ReferenceState> integrate_smooth(const Derivative& derivative, const ReferenceState& start,
                                             const std::vector<double>& times);

/// The same for right-hand sides with kinks (gaps, limits): classical Runge–Kutta in fixed steps of
/// at most `step`, which end at each of `times`.
std::vector<ReferenceState> integrate_in_steps(const Derivative& derivative, const ReferenceState& start,
                                               const std::vector<double>& times, double step);

/// Motion of one coordinate under a smooth force and dry friction that sticks.
struct FrictionSystem {
  double inertia = 1.0;                                                 ///< kg or kg·m²
  std::function<double(double time, double q, double v)> force;         ///< without friction, N or N·m
  std::function<double(double time, double q, double v)> friction_max;  ///< ≥ 0, N or N·m
};

struct CoordinateState {
  double q = 0.0;
  double v = 0.0;
};

/// States at `times`, from `start` at `times.front()`: Runge–Kutta while it slides, the moment at
/// which the velocity passes zero found by bisection, at rest as long as the force stays below the limit.
std::vector<CoordinateState> integrate_with_friction(const FrictionSystem& system, CoordinateState start,
                                                     const std::vector<double>& times, double step);

/// `count` + 1 times from 0 to `end`.
std::vector<double> evenly_spaced(double end, int count);

}  // namespace lacuna
