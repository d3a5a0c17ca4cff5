#include "bench/recording.h"
#include "recording_file.h"

/// Writes the recordings of the servo pendulum bench into the folder that it is given.
int main(int argc, char** argv) {
  return bench::write_recordings({argv, static_cast<std::size_t>(argc)}, servo_pendulum::kTrials,
                                 servo_pendulum::recording_file);
}
