#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/trial.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace lacuna {

/// The channels that read one joint's position and velocity.
struct JointReadings {
  std::vector<std::string> channels;
  bool turns = false;  ///< a hinge, else a slider
};

/// Of the measured hinges and sliders, in the robot's order.
std::vector<JointReadings> joint_readings(const RobotSpec& robot);

/// The fit trials, cut so that all together have at most `most` samples.
std::vector<Trial> beginnings(const std::vector<Trial>& trials, Eigen::Index most);

/// The trials with the readings of some channels, and their declared noise, divided by `factor`.
std::vector<Trial> divided(std::vector<Trial> trials, const std::vector<std::string>& channels, double factor);

}  // namespace lacuna
