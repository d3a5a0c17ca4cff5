#include "bench/recording.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace bench {

std::string recording_text(const std::vector<Row>& rows) {
  std::string text = "t_s,torque_Nm,angle_deg\n";
  for (const Row& row : rows) {
    char line[96];
    std::snprintf(line, sizeof line, "%.3f,%.4f,%.5f\n", row.time, row.command, row.angle * 180.0 / std::numbers::pi);
    text += line;
  }
  return text;
}

std::uint64_t noise_seed(const std::string& trial) {
  std::uint64_t seed = 0;
  for (const char letter : trial) seed = 31 * seed + static_cast<unsigned char>(letter);
  return seed;
}

int write_recordings(std::span<char*> arguments, std::span<const char* const> trials,
                     const std::function<std::string(const std::string& trial)>& text_of) {
  if (arguments.size() != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", std::filesystem::path(arguments[0]).filename().c_str());
    return 2;
  }
  for (const char* trial : trials) {
    const std::filesystem::path file = std::filesystem::path(arguments[1]) / (std::string(trial) + ".csv");
    std::ofstream out(file, std::ios::binary);
    out << text_of(trial) << std::flush;
    if (!out) {
      std::fprintf(stderr, "%s: cannot be written\n", file.c_str());
      return 1;
    }
    std::printf("%s\n", file.c_str());
  }
  return 0;
}

}  // namespace bench
