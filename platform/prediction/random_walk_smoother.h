#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace lacuna {

/// The readings of one coordinate, at its own times; NaN where it is not read. All of one length, or empty.
struct CoordinateReadings {
  std::span<const double> times;       ///< s, strictly ascending
  std::span<const double> positions;   ///< rad or m
  std::span<const double> velocities;  ///< rad/s or m/s
  double least_position_noise = 0.0;   ///< lower bounds of the readings' noise, standard deviations
  double least_velocity_noise = 0.0;
};

/// A motion without a model of the robot: position, velocity and acceleration, of which the last is a random walk.
struct SmoothedMotion {
  std::vector<double> positions, velocities, accelerations;  ///< one value per time
  std::vector<Eigen::Matrix2d> covariances;                  ///< of position and velocity
  double position_noise = 0.0;  ///< standard deviation of a reading; 0 where it is not read
  double velocity_noise = 0.0;
  double jerk = 0.0;  ///< the random walk's intensity, unit/s^2.5
};

/// Fixed-interval smoothing of all readings (H. E. Rauch, F. Tung, C. T. Striebel, AIAA J. 3 (1965) 1445-1450). Noise
/// and jerk have the sizes that maximise the likelihood of the innovations (F. C. Schweppe, IEEE Trans. Inf. Theory 11
/// (1965) 61-70). Innovations beyond ten standard deviations count as ten. Throws `Error` where fewer than five values
/// are read.
SmoothedMotion smooth_motion(const CoordinateReadings& readings);

}  // namespace lacuna
