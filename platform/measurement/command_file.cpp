#include "measurement/command_file.h"

#include "foundation/text/csv_cell.h"
#include "foundation/unit.h"
#include "measurement/names/column_name.h"
#include "measurement/csv/csv_table.h"
#include "measurement/csv/measured_text.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace lacuna {
namespace {

/// A column of the file and what it is.
struct KnownColumn {
  std::size_t index = 0;
  Channel channel;  ///< SI
  double to_si = 1.0;
};

bool is_time(const std::string& name) { return name == "t" || name == "time"; }

std::string unit_of(const CsvFormat& format, std::size_t column) {
  std::string named = unit_in_name(format.names[column]);
  if (!named.empty() || column >= format.units.size()) return named;
  return unit_of_cell(format.units[column]);
}

/// The column as that channel; nothing where its name is a different one.
std::optional<KnownColumn> known_column(const CsvFormat& format, std::size_t column, const Channel& channel,
                                        FileReport& report) {
  if (name_without_unit(format.names[column]) != channel.name && format.names[column] != channel.name)
    return std::nullopt;
  KnownColumn known{column, channel};
  const std::string written = unit_of(format, column);
  if (written.empty()) return known;
  known.to_si = parse_unit(written)->to_si;
  if (!parse_unit(written)->same_dimension(*parse_unit(channel.unit)))
    report.problem("unit " + channel.name, format.header_line, [&] {
      return fmt::format("column `{}` is in {}, but {} takes {}", excerpt(format.names[column]), written, channel.name,
                         channel.unit);
    });
  return known;
}

std::vector<KnownColumn> find_columns(const CsvFormat& format, const std::vector<Channel>& wanted, FileReport& report) {
  std::vector<KnownColumn> columns;
  for (const Channel& channel : wanted)
    for (std::size_t column = 0; column < format.names.size(); ++column)
      if (const auto known = known_column(format, column, channel, report)) {
        columns.push_back(*known);
        break;
      }
  return columns;
}

KnownColumn find_time(const CsvFormat& format, FileReport& report) {
  for (std::size_t column = 0; column < format.names.size(); ++column) {
    const std::string name(name_without_unit(format.names[column]));
    if (!is_time(name)) continue;
    return known_column(format, column, {name, "s"}, report).value();
  }
  report.problem("time", format.header_line, [&] {
    return fmt::format("no column of time; name one \"t [s]\"; the columns are {}", listed(format.names));
  });
  return {};
}

void check_times(const CsvTable& table, FileReport& report) {
  for (std::size_t row = 1; row < table.times.size(); ++row)
    if (table.times[row] <= table.times[row - 1])
      report.problem("times", table.lines[row], [&] {
        return fmt::format("time {:.9g} does not follow {:.9g}; times of commands must increase", table.times[row],
                           table.times[row - 1]);
      });
  if (table.times.size() < 2)
    report.problem("rows", 0, [] { return std::string("a test needs at least two rows, the last one for its end"); });
}

CommandSeries commands_of(const CsvTable& table, const KnownColumn& time, const std::vector<KnownColumn>& columns) {
  CommandSeries commands;
  const auto rows = static_cast<Eigen::Index>(table.times.size());
  commands.series.times.resize(rows);
  commands.series.samples.resize(rows, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t row = 0; row < table.times.size(); ++row) {
    const auto r = static_cast<Eigen::Index>(row);
    commands.series.times(r) = (table.times[row] - table.times.front()) * time.to_si;
    for (std::size_t c = 0; c < columns.size(); ++c)
      commands.series.samples(r, static_cast<Eigen::Index>(c)) = table.columns[c][row] * columns[c].to_si;
  }
  for (const KnownColumn& column : columns) commands.series.channels.push_back(column.channel);
  return commands;
}

void throw_if_any(FileReport& report) {
  if (!report.has_problems()) return;
  ProblemList problems;
  std::vector<ReadingNote> notes;
  report.move_to(problems, notes);
  problems.throw_if_any();
}

}  // namespace

std::string command_csv(const CommandSeries& commands) {
  const TimeSeries& series = commands.series;
  std::string text = "t [s]";
  for (const Channel& channel : series.channels)
    text += "," + csv_cell(fmt::format("{} [{}]", channel.name, channel.unit));
  text += '\n';
  for (Eigen::Index row = 0; row < series.times.size(); ++row) {
    text += fmt::format("{}", series.times(row));
    for (const double value : series.samples.row(row)) text += fmt::format(",{}", value);
    text += '\n';
  }
  return text;
}

CommandSeries read_command_file(const std::filesystem::path& file, const std::vector<Channel>& actuators) {
  FileReport report(file.string());
  const std::string text = read_measured_text(file, report);
  throw_if_any(report);
  const CsvFormat format = find_csv_format(text, {}, report);
  throw_if_any(report);
  const KnownColumn time = find_time(format, report);
  const std::vector<KnownColumn> columns = find_columns(format, actuators, report);
  if (columns.empty())
    report.problem("commands", format.header_line, [&] {
      std::vector<std::string> names;
      for (const Channel& actuator : actuators) names.push_back(fmt::format("{} [{}]", actuator.name, actuator.unit));
      return fmt::format("no column of commands; the robot has the commands {}", listed(names));
    });
  throw_if_any(report);
  CsvQuery query{format.names[time.index], "", {}};
  for (const KnownColumn& column : columns) query.columns.push_back({format.names[column.index], false});
  const CsvTable table = read_csv_table(text, format, query, report);
  throw_if_any(report);
  check_times(table, report);
  throw_if_any(report);
  return commands_of(table, time, columns);
}

}  // namespace lacuna
