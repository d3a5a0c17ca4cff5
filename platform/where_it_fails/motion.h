#pragma once

#include <Eigen/Core>

namespace lacuna {

/// What a velocity says about the direction of motion.
struct Motion {
  Eigen::VectorXd direction;       ///< −1, 0 (at rest) or 1
  Eigen::VectorXd since_reversal;  ///< s since the motion last came to rest or turned; since the first sample before
};

/// Speeds up to `rest`, in the unit of the velocity, count as rest. A motion ends where its speed falls to that, so
/// that the time a joint stands before it turns back counts as after the reversal.
Motion motion_of(const Eigen::VectorXd& times, const Eigen::VectorXd& velocities, double rest);

}  // namespace lacuna
