#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/trial.h>

#include <string>
#include <vector>

namespace lacuna {

/// The noise of a sensor channel, pooled over trials, and the source of this figure.
struct ChannelNoise {
  std::string channel;
  std::string unit;
  double deviation = 0.0;  ///< standard deviation, channel unit; never 0
  std::string origin;      ///< "declared", "encoder step 2.90 mrad/√12; rest agrees", ...
  bool is_guess = false;   ///< not declared, and the channel neither rests nor shows a quantisation step
};

/// Sensor noise of every channel that `trials` measure, in the order of the first trial that has it. Sources, the most
/// reliable first: the declaration of the columns; the declaration of the robot's sensor (noise and quantiser
/// step/√12); for a touch sensor, one uncertain reading beside each change; noise while the rig rests; the
/// high-frequency part of the recording (second differences), which includes fast motion. Where nothing varies at all,
/// the resolution of a double.
std::vector<ChannelNoise> sensor_noise(const RobotSpec& robot, const std::vector<Trial>& trials);

}  // namespace lacuna
