#include "measurement/guesses/column_guess.h"

#include "foundation/text/problem.h"
#include "foundation/unit.h"
#include "measurement/names/column_name.h"
#include "measurement/names/column_words.h"
#include "measurement/guesses/duplicate_columns.h"
#include "measurement/csv/file_report.h"
#include "measurement/names/header_names.h"
#include "measurement/guesses/track_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kGoesTogether = 0.05;  // root mean square distance, as a share of the range

/// The role that a unit suggests.
std::optional<ColumnRole> role_of_unit(const std::string& unit) {
  static const std::pair<std::string_view, ColumnRole> kRoles[] = {
      {"s", ColumnRole::time},      {"m", ColumnRole::position}, {"m/s", ColumnRole::velocity},
      {"N*m", ColumnRole::command}, {"N", ColumnRole::command},  {"V", ColumnRole::command},
      {"A", ColumnRole::command}};
  const std::optional<Unit> parsed = parse_unit(unit);
  if (!parsed) return std::nullopt;
  for (const auto& [symbol, role] : kRoles)
    if (parsed->same_dimension(*parse_unit(symbol))) return role;
  if (unit == "%") return ColumnRole::command;
  if (unit == "Hz") return ColumnRole::other;
  if (parsed->same_dimension(*parse_unit("rad/s"))) return ColumnRole::velocity;
  if (parsed->same_dimension(*parse_unit("rad")) && unit != "1") return ColumnRole::position;
  return ColumnRole::other;
}

/// The share of steps in which a column rises.
double rising_share(const std::vector<double>& values) {
  std::size_t rising = 0;
  for (std::size_t i = 1; i < values.size(); ++i) rising += values[i] > values[i - 1] ? 1 : 0;
  return values.size() < 2 ? 0.0 : static_cast<double>(rising) / static_cast<double>(values.size() - 1);
}

bool same_dimension_as(const std::string& unit, std::string_view other) {
  const std::optional<Unit> a = parse_unit(unit), b = parse_unit(other);
  return a && b && a->same_dimension(*b);
}

/// The role from name and unit together: a unit counts more, but does not turn a setpoint, an error or a battery into a
/// reading. A position or velocity in volts is a potentiometer's or a tachometer's; after such a word, A and N are
/// labels, not units.
ColumnRole role_of(const std::vector<std::string>& words, ColumnRole by_unit, GuessedColumn& column) {
  const std::optional<ColumnRole> by_words = role_in_words(words);
  if (by_words == ColumnRole::other) return ColumnRole::other;
  if (by_unit == ColumnRole::position || by_unit == ColumnRole::velocity)
    return tell_wanted(words) ? ColumnRole::reference : by_unit;
  if (by_unit != ColumnRole::command || !name_a_quantity(words) || by_words == ColumnRole::command) return by_unit;
  if (!column.of_voltage) column.unit.clear();
  return by_words.value_or(by_unit);
}

GuessedColumn guess_column(const FileSample& sample, std::size_t index, const std::string& core) {
  GuessedColumn guess;
  guess.name = sample.format.names[index];
  guess.unit = unit_in_name(core);
  const bool in_row = guess.unit.empty() && index < sample.format.units.size();
  if (in_row) guess.unit = sample.format.units[index];
  guess.in_si = guess.unit.empty() && sample.is_in_si(index);
  const std::vector<std::string> words = words_of(core);
  guess.joint = joint_in_words(words);
  guess.of_voltage = guess.unit.empty() ? tell_voltage(words) : same_dimension_as(guess.unit, "V");
  guess.of_velocity = tell_velocity(words);
  guess.of_effort = guess.unit.empty() ? tell_effort(words)
                                       : same_dimension_as(guess.unit, "N*m") || same_dimension_as(guess.unit, "N");
  const std::optional<ColumnRole> by_words = role_in_words(words);
  const std::optional<ColumnRole> by_unit = role_of_unit(guess.unit);
  if (by_words == ColumnRole::trial && guess.unit.empty()) {
    guess.role = ColumnRole::trial;
    guess.reason = "its name";
  } else if (!sample.is_numeric(index)) {
    guess.reason = "not numbers";
  } else if (by_unit) {
    guess.role = role_of(words, *by_unit, guess);
    guess.reason = !in_row                         ? "the unit in its name"
                   : sample.format.header_line > 0 ? "the row of units"
                                                   : "the unit in the file";
  } else if (by_words) {
    guess.role = *by_words;
    guess.reason = "its name";
  } else {
    guess.reason = "its name does not show what it measures";
  }
  if (guess.role == ColumnRole::reference) guess.reason = "its name says that it is a setpoint";
  if (guess.role == ColumnRole::other && by_words == ColumnRole::other)
    guess.reason = "its name is neither that of a motion nor of a drive";
  return guess;
}

/// Of runs side by side the first is used.
void leave_out_other_runs(const std::vector<CoreName>& cores, std::vector<GuessedColumn>& columns) {
  const auto first = std::find_if(cores.begin(), cores.end(), [](const CoreName& core) { return !core.run.empty(); });
  if (first == cores.end()) return;
  for (std::size_t i = 0; i < cores.size(); ++i) {
    if (cores[i].run.empty() || cores[i].run == first->run) continue;
    columns[i].role = ColumnRole::other;
    columns[i].reason = fmt::format("`{}` is used; copy `{}` to a separate file", first->run, cores[i].run);
    columns[i].passed_over = true;
  }
}

/// One time column: the first by name or unit that mostly increases (trials may follow each other); else the first
/// column that always does.
void settle_time(const FileSample& sample, std::vector<GuessedColumn>& columns) {
  GuessedColumn* time = nullptr;
  constexpr double kMostly = 0.8;
  for (const bool by_name : {true, false})
    for (std::size_t i = 0; i < columns.size() && !time; ++i)
      if ((columns[i].role == ColumnRole::time) == by_name && columns[i].role != ColumnRole::trial &&
          !columns[i].passed_over && rising_share(sample.columns[i]) >= (by_name ? kMostly : 1.0)) {
        time = &columns[i];
        if (!by_name) time->reason = "it rises from row to row";
      }
  for (GuessedColumn& column : columns) {
    if (&column == time || column.role != ColumnRole::time) continue;
    column.role = ColumnRole::other;
    column.reason = "a time, but not the one used";
  }
  if (time) time->role = ColumnRole::time;
}

/// Distance of two columns relative to their range; large where one has no value.
double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0.0, lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += (a[i] - b[i]) * (a[i] - b[i]) / static_cast<double>(a.size());
    lowest = std::min(lowest, a[i]);
    highest = std::max(highest, a[i]);
  }
  const double share = std::sqrt(squares) / (highest - lowest);
  return std::isfinite(share) ? share : std::numeric_limits<double>::infinity();
}

/// Whether `b` lags behind `a`: a − b is then correlated with the slope of a.
bool lags(const std::vector<double>& a, const std::vector<double>& b) {
  double product = 0.0;
  for (std::size_t i = 1; i + 1 < a.size(); ++i) product += (a[i] - b[i]) * (a[i + 1] - a[i - 1]);
  return product > 0.0;
}

void settle_references(const FileSample& sample, std::vector<GuessedColumn>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = i + 1; j < columns.size(); ++j) {
      if (columns[i].role != ColumnRole::position || columns[j].role != ColumnRole::position) continue;
      if (number_in(words_of(columns[i].name)) != number_in(words_of(columns[j].name))) continue;  // two joints
      if (columns[i].unit != columns[j].unit || distance(sample.columns[i], sample.columns[j]) > kGoesTogether)
        continue;
      const bool second_lags = lags(sample.columns[i], sample.columns[j]);
      GuessedColumn& reference = columns[second_lags ? i : j];
      const GuessedColumn& measured = columns[second_lags ? j : i];
      reference.role = ColumnRole::reference;
      reference.reason = fmt::format("`{}` follows it with a lag", measured.name);
      reference.joint = measured.joint;
    }
}

/// A voltage that hardly changes is a supply voltage, if another column may be the drive.
void settle_supplies(const FileSample& sample, std::vector<GuessedColumn>& columns) {
  constexpr double kSteady = 0.2;  ///< span over mean
  const auto drives = [](const GuessedColumn& column) {
    return column.role == ColumnRole::command || column.role == ColumnRole::reference;
  };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    GuessedColumn& column = columns[i];
    if (column.role != ColumnRole::command || !column.of_voltage) continue;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const double value : sample.columns[i]) {
      if (!std::isfinite(value)) continue;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    const double mean = 0.5 * (lowest + highest);
    if (!(highest - lowest < kSteady * std::abs(mean)) || lowest * highest <= 0.0) continue;
    if (std::ranges::none_of(columns, [&](const GuessedColumn& other) {
          return &other != &column && drives(other) && !other.of_voltage;
        }))
      continue;
    column.role = ColumnRole::other;
    column.reason = fmt::format("it stays near {:.3g}{}: a supply voltage, not a drive", mean,
                                column.unit.empty() ? "" : " " + column.unit);
  }
}

void apply_hint(const FileSample& sample, const std::vector<std::string>& names, ColumnRole role,
                std::vector<GuessedColumn>& columns) {
  if (names.empty()) return;
  for (GuessedColumn& column : columns)
    if (column.role == role) {
      column.role = ColumnRole::other;
      column.reason = "not among those you named";
      column.passed_over = true;
    }
  for (const std::string& name : names) {
    const int index = sample.find(name);
    if (index < 0)
      throw_problem({sample.path.string(), sample.first_place(), 0},
                    fmt::format("no column `{}`{}; the columns are {}", name, did_you_mean(name, sample.format.names),
                                listed(sample.format.names)));
    GuessedColumn& column = columns[static_cast<std::size_t>(index)];
    column.role = role;
    column.reason = "you named it";
    column.named_by_user = true;
    column.passed_over = false;
  }
}

}  // namespace

std::vector<GuessedColumn> guess_columns(const FileSample& sample, const ColumnHints& hints) {
  std::vector<GuessedColumn> columns;
  const std::vector<CoreName> cores = core_names(sample.format.names);
  for (std::size_t i = 0; i < cores.size(); ++i) columns.push_back(guess_column(sample, i, cores[i].text));
  leave_out_other_runs(cores, columns);
  settle_time(sample, columns);
  leave_out_duplicates(sample, columns);
  settle_supplies(sample, columns);
  settle_tracks(sample, columns);
  settle_references(sample, columns);
  if (!hints.time.empty()) apply_hint(sample, {hints.time}, ColumnRole::time, columns);
  apply_hint(sample, hints.positions, ColumnRole::position, columns);
  apply_hint(sample, hints.velocities, ColumnRole::velocity, columns);
  apply_hint(sample, hints.commands, ColumnRole::command, columns);
  return columns;
}

}  // namespace lacuna
