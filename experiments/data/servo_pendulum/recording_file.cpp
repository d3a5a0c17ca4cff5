#include "recording_file.h"

#include "bench.h"

namespace servo_pendulum {

std::string recording_file(const std::string& trial) {
  const Truth truth;
  return bench::recording_text(record(excitation(trial, truth), truth, bench::noise_seed(trial)));
}

}  // namespace servo_pendulum
