#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/trial.h>

#include <string>
#include <vector>

namespace lacuna {

/// The noise of a sensor channel, pooled over trials, and where that figure comes from.
struct ChannelNoise {
  std::string channel;
  std::string unit;
  double deviation = 0.0;  ///< standard deviation, channel unit; never 0
  std::string origin;      ///< "declared", "encoder step 2.90 mrad/√12; rest agrees", ...
  bool is_guess = false;   ///< nothing declares it, and the channel neither rests nor shows its step
};

/// Sensor noise of every channel that `trials` measure, in the order of the first trial that has it.
/// In order of trust: what the columns declare; what the robot's sensor declares (noise and quantiser
/// step/√12); of a touch sensor, one uncertain reading beside each change; noise while the rig rests; the
/// high-frequency part of the recording (second differences), which takes fast motion for noise. Where nothing varies
/// at all, the resolution of a double.
std::vector<ChannelNoise> sensor_noise(const RobotSpec& robot, const std::vector<Trial>& trials);

}  // namespace lacuna
