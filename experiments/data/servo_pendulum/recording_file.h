#pragma once

#include <string>
#include <vector>

namespace servo_pendulum {

/// The recordings of this folder.
inline constexpr const char* kTrials[] = {"sine", "steps", "multisine", "chirp"};

/// The whole text of a trial's CSV file: time in s, torque command in N·m, encoder angle in degrees.
std::string recording_file(const std::string& trial);

}  // namespace servo_pendulum
