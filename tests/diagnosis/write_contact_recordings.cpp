// Writes recordings of robots with contacts, and the experiments to diagnose them:
//   write_contact_recordings FOLDER hopper|quadruped TRIALS SECONDS [hidden]
// where hidden is "restitution=0.4" and the like for a hopper, the text of an effect for a quadruped.

#include "diagnosis/recorded_hopper.h"
#include "diagnosis/recorded_quadruped.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

namespace {

using namespace lacuna;

void write_csv(const Trial& trial, const std::filesystem::path& folder) {
  std::ofstream file(folder / trial.name);
  file << "t_s";
  for (const TimeSeries* series : {&trial.commands.series, &trial.measured})
    for (const Channel& channel : series->channels) file << ',' << channel.name;
  file << '\n';
  for (Eigen::Index row = 0; row < trial.measured.times.size(); ++row) {
    file << fmt::format("{:.6f}", trial.measured.times(row));
    for (const TimeSeries* series : {&trial.commands.series, &trial.measured})
      for (const double value : series->samples.row(row)) file << fmt::format(",{:.9g}", value);
    file << '\n';
  }
}

HopperTruth hopper_truth(const std::string& hidden) {
  HopperTruth truth;
  const std::size_t equals = hidden.find('=');
  if (equals == std::string::npos) return truth;
  const std::string name = hidden.substr(0, equals);
  const double value = std::stod(hidden.substr(equals + 1));
  (name == "restitution" ? truth.restitution : name == "viscous" ? truth.viscous : truth.dry) = value;
  return truth;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  if (arguments.size() < 4) {
    std::cerr << "usage: write_contact_recordings FOLDER hopper|quadruped TRIALS SECONDS [hidden]\n";
    return 2;
  }
  const std::filesystem::path folder = arguments[0];
  const std::size_t trials = std::stoul(arguments[2]);
  const double seconds = std::stod(arguments[3]);
  const std::string hidden = arguments.size() > 4 ? arguments[4] : "";
  std::filesystem::create_directories(folder);
  const bool hopper = arguments[1] == "hopper";
  std::ofstream(folder / "rig.toml") << (hopper ? hopper_experiment(trials) : quadruped_experiment(trials));
  if (hopper) std::ofstream(folder / "hopper.toml") << hopper_robot_file();
  for (const Trial& trial : hopper ? hopper_trials(hopper_truth(hidden), trials, seconds)
                                   : quadruped_trials({.effects = hidden}, trials, seconds))
    write_csv(trial, folder);
  return 0;
}
