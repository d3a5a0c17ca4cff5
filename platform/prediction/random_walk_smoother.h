#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace lacuna {

/// What is read of one coordinate, at times of its own; NaN where it is not read. All of one length, or empty.
struct CoordinateReadings {
  std::span<const double> times;       ///< s, strictly ascending
  std::span<const double> positions;   ///< rad or m
  std::span<const double> velocities;  ///< rad/s or m/s
  double least_position_noise = 0.0;   ///< standard deviations below which no reading's noise is believed to be
  double least_velocity_noise = 0.0;
};

/// A motion without a model of what moves: position, velocity and acceleration, of which the last is a random walk.
struct SmoothedMotion {
  std::vector<double> positions, velocities, accelerations;  ///< a value a time
  std::vector<Eigen::Matrix2d> covariances;                  ///< of position and velocity
  double position_noise = 0.0;  ///< standard deviation of a reading; 0 where it is not read
  double velocity_noise = 0.0;
  double jerk = 0.0;  ///< the random walk's intensity, unit/s^2.5
};

/// Fixed-interval smoothing of all readings (H. E. Rauch, F. Tung, C. T. Striebel, AIAA J. 3 (1965) 1445-1450). The
/// sizes of noise and jerk are those under which the innovations are likeliest (F. C. Schweppe, IEEE Trans. Inf. Theory
/// 11 (1965) 61-70). Readings that are more than ten standard deviations from what those before foretell count as
/// though they were at ten. Throws `Error` where fewer than five values are read.
SmoothedMotion smooth_motion(const CoordinateReadings& readings);

}  // namespace lacuna
