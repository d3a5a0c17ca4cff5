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

/// Of the hinges and sliders that are read, in the robot's order.
std::vector<JointReadings> joint_readings(const RobotSpec& robot);

/// The trials that are fitted to, cut so that all together have at most `most` samples.
std::vector<Trial> beginnings(const std::vector<Trial>& trials, Eigen::Index most);

/// The trials with the readings of some channels, and what is declared of their noise, divided by `factor`.
std::vector<Trial> divided(std::vector<Trial> trials, const std::vector<std::string>& channels, double factor);

}  // namespace lacuna
