#include "recording_file.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

/// Writes the recordings of the servo pendulum bench into the folder that it is given.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: generate_servo_pendulum FOLDER\n");
    return 2;
  }
  for (const char* trial : servo_pendulum::kTrials) {
    const std::filesystem::path file = std::filesystem::path(argv[1]) / (std::string(trial) + ".csv");
    std::ofstream out(file, std::ios::binary);
    out << servo_pendulum::recording_file(trial) << std::flush;
    if (!out) {
      std::fprintf(stderr, "%s: cannot be written\n", file.c_str());
      return 1;
    }
    std::printf("%s\n", file.c_str());
  }
  return 0;
}
