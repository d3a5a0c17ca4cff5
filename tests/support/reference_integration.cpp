#include "support/reference_integration.h"

#include "support/tolerances.h"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <cmath>
#include <cstddef>

namespace lacuna {

namespace odeint = boost::numeric::odeint;

std::vector<ReferenceState> integrate_smooth(const Derivative& derivative, const ReferenceState& start,
                                             const std::vector<double>& times) {
  constexpr double kFirstStep = 1e-4;
  const auto stepper =
      odeint::make_controlled<odeint::runge_kutta_fehlberg78<ReferenceState>>(kReferenceTolerance, kReferenceTolerance);
  std::vector<ReferenceState> states{start};
  ReferenceState state = start;
  for (std::size_t i = 1; i < times.size(); ++i) {
    odeint::integrate_adaptive(stepper, derivative, state, times[i - 1], times[i], kFirstStep);
    states.push_back(state);
  }
  return states;
}

std::vector<ReferenceState> integrate_in_steps(const Derivative& derivative, const ReferenceState& start,
                                               const std::vector<double>& times, double step) {
  odeint::runge_kutta4<ReferenceState> stepper;
  std::vector<ReferenceState> states{start};
  ReferenceState state = start;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double span = times[i] - times[i - 1];
    const int count = static_cast<int>(std::ceil(span / step - 1e-9));
    const double h = span / count;
    for (int k = 0; k < count; ++k) stepper.do_step(derivative, state, times[i - 1] + k * h, h);
    states.push_back(state);
  }
  return states;
}

namespace {

/// Slides in the fixed direction `sign` for `h` by one Runge–Kutta step.
CoordinateState slide(const FrictionSystem& system, const CoordinateState& at, double time, double h, double sign) {
  const auto acceleration = [&](double t, double q, double v) {
    return (system.force(t, q, v) - sign * system.friction_max(t, q, v)) / system.inertia;
  };
  const double v1 = at.v, a1 = acceleration(time, at.q, at.v);
  const double v2 = at.v + h / 2 * a1, a2 = acceleration(time + h / 2, at.q + h / 2 * v1, v2);
  const double v3 = at.v + h / 2 * a2, a3 = acceleration(time + h / 2, at.q + h / 2 * v2, v3);
  const double v4 = at.v + h * a3, a4 = acceleration(time + h, at.q + h * v3, v4);
  return {at.q + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), at.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}

/// The share of `h` after which the sliding velocity is zero.
double time_of_stop(const FrictionSystem& system, const CoordinateState& at, double time, double h, double sign) {
  double low = 0.0, high = h;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (slide(system, at, time, middle, sign).v * sign > 0.0 ? low : high) = middle;
  }
  return high;
}

CoordinateState friction_step(const FrictionSystem& system, CoordinateState at, double time, double h) {
  double sign = at.v > 0.0 ? 1.0 : at.v < 0.0 ? -1.0 : 0.0;
  double done = 0.0;
  if (sign != 0.0) {
    const CoordinateState next = slide(system, at, time, h, sign);
    if (next.v * sign > 0.0) return next;
    done = time_of_stop(system, at, time, h, sign);
    at = {slide(system, at, time, done, sign).q, 0.0};
  }
  const double force = system.force(time + done, at.q, 0.0);
  if (std::abs(force) <= system.friction_max(time + done, at.q, 0.0)) return at;
  sign = force > 0.0 ? 1.0 : -1.0;
  return slide(system, at, time + done, h - done, sign);
}

}  // namespace

std::vector<CoordinateState> integrate_with_friction(const FrictionSystem& system, CoordinateState start,
                                                     const std::vector<double>& times, double step) {
  std::vector<CoordinateState> states{start};
  CoordinateState at = start;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double span = times[i] - times[i - 1];
    const int count = static_cast<int>(std::ceil(span / step - 1e-9));
    const double h = span / count;
    for (int k = 0; k < count; ++k) at = friction_step(system, at, times[i - 1] + k * h, h);
    states.push_back(at);
  }
  return states;
}

std::vector<double> evenly_spaced(double end, int count) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(end * i / count);
  return times;
}

}  // namespace lacuna
