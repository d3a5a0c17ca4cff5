#pragma once

#include "fitting/analytic_models.h"

#include <span>

namespace lacuna::analytic {

inline constexpr double kNoise = 1e-3;  // rad

/// q'' = u − b q' − 4 q; value: b.
inline double spring(std::span<const double> values, double q, double v, double u) {
  return u - values[0] * v - 4.0 * q;
}

inline ModelDefinition spring_definition() {
  return define({free_value("joint.hinge.damping", 0.1, 0.0, 10.0)}, one_joint_robot());
}

inline Trial spring_trial(double noise, std::uint64_t seed, double duration = 5.0, double rate = 200.0) {
  return record(OneJointModel(spring), {0.5}, regular_times(static_cast<Eigen::Index>(rate * duration) + 1, rate),
                two_sines(duration, 1.5), {{0.3}, {-0.2}}, noise, seed);
}

}  // namespace lacuna::analytic
