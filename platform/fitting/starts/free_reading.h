#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/time_series.h>

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace lacuna {

/// A coordinate with its rate estimated from data, and their standard deviations.
struct CoordinateReading {
  double position = 0.0, velocity = 0.0;
  double position_deviation = 0.0, velocity_deviation = 0.0;
};

/// The measured channels that determine the coordinates of a free joint: position and orientation of its body.
class FreeReading {
 public:
  /// Of the joint `joint` of the robot. `deviations`: of the measured channels.
  FreeReading(const RobotSpec& robot, const JointSpec& joint, const TimeSeries& measured,
              const std::vector<double>& deviations);

  /// Whether the displacement (0 to 2) or the rotation vector (3 to 5) is measured.
  bool tells(int coordinate) const;
  /// The six coordinates at a sample, from low polynomials over `window` s near it within `range` (first, one past
  /// last); rates of the rotation are angular velocities. Nothing where too little was measured.
  std::array<std::optional<CoordinateReading>, 6> at(const TimeSeries& measured,
                                                     std::pair<Eigen::Index, Eigen::Index> range, Eigen::Index sample,
                                                     double window) const;

 private:
  std::optional<Eigen::Quaterniond> turn(const TimeSeries& measured, Eigen::Index row) const;
  TimeSeries nearby(const TimeSeries& measured, std::pair<Eigen::Index, Eigen::Index> range,
                    const Eigen::Quaterniond& about) const;

  std::optional<Eigen::Index> place_, turn_;  ///< first of three, of four channels
  double place_noise_ = 0.0, turn_noise_ = 0.0;
  Eigen::Vector3d com_{0.0, 0.0, 0.0}, zero_place_{0.0, 0.0, 0.0};
  Eigen::Quaterniond zero_turn_ = Eigen::Quaterniond::Identity();
};

}  // namespace lacuna
