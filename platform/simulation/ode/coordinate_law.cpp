#include "simulation/ode/coordinate_law.h"

#include <algorithm>
#include <cmath>

namespace lacuna::ode {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// The velocity, if every law were in the regime that it is in at `at`: at its limit or not.
double velocity_near(double at, double free, double mobility, std::span<const CoordinateLaw> laws) {
  double pushed = free, resistance = 1.0;
  for (const CoordinateLaw& law : laws) {
    const double missing = law.target - at;
    if (missing > law.compliance * law.upper) {
      pushed += mobility * law.upper;
    } else if (missing < law.compliance * law.lower) {
      pushed += mobility * law.lower;
    } else {
      pushed += mobility * law.target / law.compliance;
      resistance += mobility / law.compliance;
    }
  }
  return pushed / resistance;
}

/// A place between two, of which either may be infinitely far away.
double between(double lower, double upper) {
  if (std::isfinite(lower) && std::isfinite(upper)) return 0.5 * (lower + upper);
  if (std::isfinite(lower)) return lower + 1.0;
  return std::isfinite(upper) ? upper - 1.0 : 0.0;
}

}  // namespace

double settled_velocity(double free, double mobility, std::span<const CoordinateLaw> laws) {
  // Where laws reach their limits the slope changes; between two such places everything is linear.
  double lower = -kNowhere, upper = kNowhere;
  for (const CoordinateLaw& law : laws)
    for (const double limit : {law.lower, law.upper}) {
      const double edge = law.target - law.compliance * limit;
      if (!(edge > lower && edge < upper)) continue;
      (velocity_near(edge, free, mobility, laws) >= edge ? lower : upper) = edge;
    }
  return std::clamp(velocity_near(between(lower, upper), free, mobility, laws), lower, upper);
}

}  // namespace lacuna::ode
