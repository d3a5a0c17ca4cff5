#pragma once

#include "diagnosis/residual_force/joint_motion.h"

#include <array>

namespace lacuna {

/// What a free force has beyond a function of a joint's position and one of its velocity: products of the two, such as
/// damping that depends on the position. Each function is a Legendre polynomial of the position, over the range that
/// the joint covered, times one of the velocity or the direction of motion; both factors have mean zero over the
/// motion, so that they leave to the sums what sums can say.
class ForceInteraction {
 public:
  static constexpr int kPositions = 4;                           ///< degrees 1 to 4 of the position ...
  static constexpr int kVelocities = 3;                          ///< ... by degrees 1 to 3 of the velocity ...
  static constexpr int kCount = kPositions * (kVelocities + 1);  ///< ... and its sign

  explicit ForceInteraction(const JointMotion& motion);

  /// The functions at position `q` (rad or m) and velocity `v` (rad/s or m/s).
  Eigen::Vector<double, kCount> at(double q, double v) const;

 private:
  using Positions = Eigen::Vector<double, kPositions>;
  using Velocities = Eigen::Vector<double, kVelocities + 1>;
  Positions of_position(double q) const;
  Velocities of_velocity(double v) const;

  std::array<double, 2> positions_{}, velocities_{};  ///< middle and half of the range
  Positions mean_of_position_ = Positions::Zero();
  Velocities mean_of_velocity_ = Velocities::Zero();
};

}  // namespace lacuna
