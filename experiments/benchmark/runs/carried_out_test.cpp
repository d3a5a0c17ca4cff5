#include "runs/carried_out_test.h"

#include "cases/recorded_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kLate = 1e-6;  ///< s, of a row

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw std::runtime_error(fmt::format("the commands in {} cannot be read: {}", file.filename().string(), reason));
}

double number_in(const std::string& cell, const std::filesystem::path& file) {
  double value = 0.0;
  const char* const end = cell.data() + cell.size();
  const auto [rest, error] = std::from_chars(cell.data(), end, value);
  if (error != std::errc() || rest != end) refuse(file, "\"" + cell + "\" is no number");
  return value;
}

/// Of each drive, by the name before the unit: "motor [N*m]".
std::vector<std::size_t> columns_of_drives(const std::vector<std::string>& head, const PlantSpec& spec,
                                           const std::filesystem::path& file) {
  std::vector<std::size_t> columns;
  for (const PlantDrive& drive : spec.drives) {
    const auto found = std::find_if(head.begin(), head.end(),
                                    [&](const std::string& cell) { return cell.starts_with(drive.name + " ["); });
    if (found == head.end()) refuse(file, "there is no column for " + drive.name);
    columns.push_back(static_cast<std::size_t>(found - head.begin()));
  }
  return columns;
}

}  // namespace

Excitation read_commands(const std::filesystem::path& file, const PlantSpec& spec, double interval) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) refuse(file, "it is empty");
  const std::vector<std::string> head = cells_of(line);
  const std::vector<std::size_t> columns = columns_of_drives(head, spec, file);
  Excitation excitation;
  excitation.interval = interval;
  excitation.commands.resize(columns.size());
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != head.size()) refuse(file, "a row has another number of cells than the first");
    const double due = static_cast<double>(excitation.samples()) * interval;
    if (!(std::abs(number_in(cells[0], file) - due) < kLate))
      refuse(file, fmt::format("a row is due at {:g} s, but {} s stands there", due, cells[0]));
    for (std::size_t d = 0; d < columns.size(); ++d)
      excitation.commands[d].push_back(number_in(cells[columns[d]], file));
  }
  if (excitation.samples() < 2) refuse(file, "it has no two rows");
  return excitation;
}

MadeTrial carried_out_test(const MadeCase& made, const std::filesystem::path& commands, std::uint64_t seed) {
  return recorded_trial(made, read_commands(commands, made.truth.spec, made.trials.front().applied.interval), seed);
}

}  // namespace hidden_effects
