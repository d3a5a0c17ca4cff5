#include "bench/recording.h"
#include "flap.h"

/// Writes the recordings of the damped flap into the folder that it is given.
int main(int argc, char** argv) {
  return bench::write_recordings({argv, static_cast<std::size_t>(argc)}, damped_flap::kTrials,
                                 damped_flap::recording_file);
}
