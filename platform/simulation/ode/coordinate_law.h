#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace lacuna::ode {

/// A law on a joint coordinate: a force within [lower, upper] such that velocity + compliance·force = target at the end
/// of the step. SI; the compliance is positive.
struct CoordinateLaw {
  double target = 0.0;
  double compliance = 0.0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  std::size_t coordinate = 0;
};

/// The velocity at which all laws hold, where they move the coordinate from `free` by `mobility` times the sum of their
/// forces. There is exactly one, since no force grows with the velocity.
double settled_velocity(double free, double mobility, std::span<const CoordinateLaw> laws);

}  // namespace lacuna::ode
