#include "recording_file.h"

#include "bench.h"

#include <cstdio>
#include <numbers>

namespace servo_pendulum {
namespace {

/// A different one for every trial, the same for ever.
std::uint64_t noise_seed(const std::string& trial) {
  std::uint64_t seed = 0;
  for (const char letter : trial) seed = 31 * seed + static_cast<unsigned char>(letter);
  return seed;
}

}  // namespace

std::string recording_file(const std::string& trial) {
  const Truth truth;
  std::string text = "t_s,torque_Nm,angle_deg\n";
  for (const Row& row : record(excitation(trial, truth), truth, noise_seed(trial))) {
    char line[96];
    std::snprintf(line, sizeof line, "%.3f,%.4f,%.5f\n", row.time, row.command, row.angle * 180.0 / std::numbers::pi);
    text += line;
  }
  return text;
}

}  // namespace servo_pendulum
