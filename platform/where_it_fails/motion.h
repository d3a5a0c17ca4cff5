#pragma once

#include <Eigen/Core>

namespace lacuna {

/// Direction of motion from a velocity.
struct Motion {
  Eigen::VectorXd direction;       ///< −1, 0 (at rest) or 1
  Eigen::VectorXd since_reversal;  ///< s since the motion last came to rest or reversed; before the first such time,
                                   ///< since the first sample
};

/// Speeds up to `rest`, in the unit of the velocity, count as rest. A motion ends where its speed falls to `rest`, so
/// the time at rest before a reversal counts as after the reversal.
Motion motion_of(const Eigen::VectorXd& times, const Eigen::VectorXd& velocities, double rest);

}  // namespace lacuna
