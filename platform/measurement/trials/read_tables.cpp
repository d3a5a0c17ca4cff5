#include "measurement/trials/read_tables.h"

#include "foundation/unit.h"
#include "measurement/clocks/clock_wraps.h"
#include "measurement/csv/csv_runs.h"
#include "measurement/trials/decode_tables.h"
#include "measurement/trials/foreign_table.h"
#include "measurement/trials/join_tables.h"
#include "measurement/trials/opened_file.h"
#include "measurement/trials/track_angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace lacuna {
namespace {

std::vector<std::string> names_of_columns(const RecordingPlan& plan) {
  std::vector<std::string> names;
  for (const PlannedColumn* column : columns_of(plan)) names.push_back(column->mapping->column);
  for (const PlannedSwitch& one : plan.switches) names.push_back(one.column);
  for (const PlannedColumn& sensor : plan.sensors)
    if (const std::string& other = sensor.mapping->track.other; !other.empty()) names.push_back(other);
  return names;
}

/// A missing column may be the experiment's mistake or the file's: the message names both.
void check_column(const std::string& name, OpenedFile& file) {
  const std::vector<std::string>& names = file.paths.empty() ? file.format.names : file.paths;
  const std::size_t count = file.count(name);
  if (count == 1 || !file.told.insert(name).second) return;
  file.report.problem("column " + name, file.format.header_line, [&] {
    if (count > 1) return fmt::format("{} columns have the name `{}`; rename all but one", count, excerpt(name));
    if (file.run.empty() && std::ranges::any_of(file.runs, [&](const std::string& run) {
          return NameIndex(names_of_run(names, run)).count(name) > 0;
        }))
      return fmt::format(
          "no column `{}`, but one in each of the runs {}; write [[target.recording]] with this file and table = "
          "\"{}\"",
          excerpt(name), listed(file.runs), file.runs.front());
    return fmt::format("no column `{}`{}; the columns are {}", excerpt(name), did_you_mean(name, names), listed(names));
  });
}

/// The columns of an entry of `with` must exist and be used.
void check_named(const std::string& name, const std::vector<std::string>& wanted, OpenedFile& file) {
  if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) return check_column(name, file);
  file.report.problem("named " + name, 0, [&] {
    return fmt::format("columns names `{}`{}, which the experiment reads from no file; it reads {}", excerpt(name),
                       did_you_mean(name, wanted), listed(wanted));
  });
}

/// The file of a column: the one that names it, else the first, else the only other one that has it.
std::size_t file_of(const std::string& name, std::vector<OpenedFile>& files) {
  std::vector<std::size_t> sources;
  for (std::size_t f = 1; f < files.size(); ++f)
    if (files[f].is_named(name)) sources.push_back(f);
  const bool is_named = !sources.empty();
  if (!is_named && files.front().has(name)) return 0;
  for (std::size_t f = 1; f < files.size() && !is_named; ++f)
    if (files[f].only.empty() && files[f].has(name)) sources.push_back(f);
  if (sources.size() > 1)
    files[sources.front()].report.problem("column " + name, files[sources.front()].format.header_line, [&] {
      return fmt::format("column `{}` is also {} {}; let columns = [...] of only one file name it", excerpt(name),
                         is_named ? "named for" : "in", files[sources[1]].path.string());
    });
  return sources.empty() ? 0 : sources.front();
}

void allot_columns(const std::vector<std::string>& wanted, const std::string& trial_column,
                   std::vector<OpenedFile>& files) {
  for (OpenedFile& file : files) {
    check_column(file.time_column, file);
    for (const std::string& name : file.only) check_named(name, wanted, file);
  }
  if (!trial_column.empty()) check_column(trial_column, files.front());
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    OpenedFile& file = files[file_of(wanted[c], files)];
    check_column(wanted[c], file);
    file.given.push_back(c);
  }
}

/// Seconds and fractions in two columns are one time stamp.
void name_fraction(const OpenedFile& file, double seconds_per_unit, CsvQuery& query) {
  const auto fraction = fraction_beside(file.time_column, file.format.names);
  if (seconds_per_unit != 1.0 || !fraction) return;
  query.fraction_column = fraction->name;
  query.fraction_unit = fraction->unit;
}

void note_fraction(const OpenedFile& file, const CsvQuery& query, FileReport& report) {
  report.note("two columns of time", file.format.header_line, [&] {
    return fmt::format("time stamps are the seconds in column `{}` plus column `{}` times {:g} s", file.time_column,
                       query.fraction_column, query.fraction_unit);
  });
}

double seconds_per_unit_of(const OpenedFile& file) {
  const std::optional<Unit> unit = parse_unit(file.time_unit);
  return unit ? unit->to_si : 1.0;
}

/// The request to a file, in its own names.
CsvQuery query_for(const RecordingSource& source, const std::vector<std::string>& wanted, const OpenedFile& file) {
  CsvQuery query;
  query.time_column = file.own_name(file.time_column);
  if (!source.trial_column.empty()) query.trial_column = file.own_name(source.trial_column);
  name_fraction(file, seconds_per_unit_of(file), query);
  for (const std::size_t c : file.given) query.columns.push_back({file.own_name(wanted[c])});
  query.has_other_runs = !file.run.empty() && file.runs.size() > 1;
  query.shared_clock = file.shares_clock;
  return query;
}

/// Frees the file's text, which is no longer used.
CsvTable table_of(const CsvQuery& query, std::optional<RecordedRows>& rows, OpenedFile& file) {
  if (rows) return table_of_rows(std::move(*rows), query, file.report);
  const std::string text = std::move(file.text);
  return read_csv_table(text, file.format, query, file.report);
}

/// Times since 1970 of a format that knows its clock count from the file's first, like dates.
void date_times(const OpenedFile& file, double seconds_per_unit, CsvTable& table) {
  constexpr double kThisCentury = 1e9;  ///< s since 1970
  if (!file.has_own_clock || seconds_per_unit != 1.0 || table.times.empty() || table.time_origin < kThisCentury) return;
  table.dated = true;
  table.first_date = table.times.front();
}

/// The messages about a file that is not read.
ReadTable unread(std::size_t columns, OpenedFile& file) {
  ReadTable read{std::move(file.report), {}};
  read.table.columns.resize(columns);
  return read;
}

/// `rows`: of a file that is not CSV; none where it, or another of its tables, has problems.
ReadTable read_table(const RecordingSource& source, const RecordingPlan& plan, const std::vector<std::string>& wanted,
                     std::optional<RecordedRows> rows, OpenedFile& file) {
  if (file.report.has_problems() || (file.table && !rows)) return unread(wanted.size(), file);
  const CsvQuery query = query_for(source, wanted, file);
  CsvTable table = table_of(query, rows, file);
  ReadTable read{std::move(file.report), std::move(table)};
  const double seconds_per_unit = seconds_per_unit_of(file);
  date_times(file, seconds_per_unit, read.table);
  if (read.table.has_fractions) note_fraction(file, query, read.report);
  std::vector<std::vector<double>> columns(wanted.size());
  for (std::size_t i = 0; i < file.given.size(); ++i) columns[file.given[i]] = std::move(read.table.columns[i]);
  read.table.columns = std::move(columns);
  make_angles_of_tracks(plan, read);
  if (!read.report.has_problems()) decode_clock({file.time_column, file.time_encoding, seconds_per_unit}, read);
  return read;
}

/// Asks each file that is not CSV once for the rows of all of its tables.
std::vector<std::optional<RecordedRows>> read_formats(const RecordingSource& source,
                                                      const std::vector<std::string>& wanted,
                                                      const RecordingFormats* formats,
                                                      std::vector<OpenedFile>& tables) {
  std::vector<std::optional<RecordedRows>> rows(tables.size());
  for (std::size_t t = 0; t < tables.size(); ++t) {
    if (!tables[t].table || rows[t]) continue;
    bool is_good = true;
    std::vector<std::size_t> of_file;
    std::vector<TableQuery> queries;
    for (std::size_t other = t; other < tables.size(); ++other) {
      if (!tables[other].table || tables[other].path != tables[t].path) continue;
      is_good = is_good && !tables[other].report.has_problems();
      of_file.push_back(other);
      queries.push_back(rows_query(query_for(source, wanted, tables[other]), *tables[other].table));
    }
    if (!is_good) continue;
    ReadRows read = formats->read(tables[t].path, queries);
    report_reading(read, tables[t].report);
    if (!read.problems.empty()) continue;
    read.tables.resize(of_file.size());
    for (std::size_t i = 0; i < of_file.size(); ++i) rows[of_file[i]] = std::move(read.tables[i]);
  }
  return rows;
}

}  // namespace

bool ReadRecording::has_problems() const {
  return report.has_problems() ||
         std::any_of(further.begin(), further.end(), [](const FileReport& one) { return one.has_problems(); });
}

std::vector<const PlannedColumn*> columns_of(const RecordingPlan& plan) {
  std::vector<const PlannedColumn*> columns;
  for (const auto* planned : {&plan.sensors, &plan.commands, &plan.references})
    for (const PlannedColumn& column : *planned) columns.push_back(&column);
  return columns;
}

std::vector<std::vector<std::size_t>> rows_by_trial(const CsvTable& table) {
  std::vector<std::vector<std::size_t>> rows(std::max<std::size_t>(table.trial_names.size(), 1));
  for (std::size_t row = 0; row < table.times.size(); ++row)
    rows[table.trials.empty() ? 0 : static_cast<std::size_t>(table.trials[row])].push_back(row);
  return rows;
}

std::vector<ReadRecording> read_tables(const RecordingSource& source, const RecordingPlan& plan,
                                       const RecordingFormats* formats) {
  const std::vector<std::string> wanted = names_of_columns(plan);
  std::vector<ReadTable> tables;
  std::vector<MeasuredFile> files;
  for (const MeasuredFile& file : source.files) {
    OpenedRecording opened = open_recording(source, plan, file, wanted, formats);
    const bool all_open = !opened.has_problems();
    if (all_open) allot_columns(wanted, source.trial_column, opened.tables);
    std::vector<std::optional<RecordedRows>> rows(opened.tables.size());
    if (all_open) rows = read_formats(source, wanted, formats, opened.tables);
    for (std::size_t t = 0; t < rows.size(); ++t)
      tables.push_back(all_open ? read_table(source, plan, wanted, std::move(rows[t]), opened.tables[t])
                                : unread(wanted.size(), opened.tables[t]));
    files.push_back(std::move(opened.file));
  }
  decode_tables(plan, tables);
  std::vector<ReadRecording> recordings;
  auto next = std::make_move_iterator(tables.begin());
  for (const MeasuredFile& file : files) {
    const auto end = next + static_cast<std::ptrdiff_t>(file.with.size()) + 1;
    recordings.push_back(join_tables(source, plan, file, std::vector<ReadTable>(next, end)));
    next = end;
  }
  return recordings;
}

}  // namespace lacuna
