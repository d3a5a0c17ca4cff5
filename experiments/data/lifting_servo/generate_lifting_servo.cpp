#include "bench/recording.h"
#include "servo.h"

/// Writes the recordings of the lifting servo into the folder that it is given.
int main(int argc, char** argv) {
  return bench::write_recordings({argv, static_cast<std::size_t>(argc)}, lifting_servo::kTrials,
                                 lifting_servo::recording_file);
}
