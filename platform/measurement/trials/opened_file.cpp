#include "measurement/trials/opened_file.h"

#include "measurement/csv/csv_runs.h"
#include "measurement/names/header_names.h"
#include "measurement/csv/measured_text.h"
#include "measurement/trials/plausibility.h"
#include "measurement/trials/unread_drives.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

/// The contents of a file of another format, and its first table.
struct OpenedTables {
  RecordingContents contents;
  std::size_t first = 0;
};

std::vector<std::string> paths_of(const RecordingContents& contents) {
  std::vector<std::string> paths;
  for (const RecordedTable& table : contents.tables)
    for (const RecordedColumn& column : table.columns) paths.push_back(column_path(table.name, column.name));
  return paths;
}

std::vector<std::string> names_of_tables(const RecordingContents& contents) {
  std::vector<std::string> names;
  for (const RecordedTable& table : contents.tables) names.push_back(table.name);
  return names;
}

/// Names and units of all columns, as the experiment names them.
CsvFormat format_of_all(const RecordingContents& contents) {
  CsvFormat format;
  format.names = paths_of(contents);
  for (const RecordedTable& table : contents.tables)
    for (const RecordedColumn& column : table.columns)
      format.units.push_back(column.unit == kSomeSiUnit ? "" : column.unit);
  return format;
}

void take_table(const RecordingContents& contents, std::size_t index, OpenedFile& file) {
  const RecordedTable& table = contents.tables[index];
  file.table = table.name;
  for (const RecordedColumn& column : table.columns) file.format.names.push_back(column.name);
  file.columns = NameIndex(file.format.names);
  if (contents.tables.size() > 1) file.paths = paths_of(contents);
  file.has_own_clock = !table.time_column.empty();
  if (file.has_own_clock && !file.has(file.time_column)) {
    file.time_column = table.time_column;
    file.time_unit = "s";
  }
}

std::optional<std::size_t> table_named(const RecordingContents& contents, const std::string& name) {
  const auto found = std::find_if(contents.tables.begin(), contents.tables.end(),
                                  [&](const RecordedTable& table) { return table.name == name; });
  if (found == contents.tables.end()) return std::nullopt;
  return static_cast<std::size_t>(found - contents.tables.begin());
}

/// The table that a column's path names.
std::optional<std::size_t> table_of(const RecordingContents& contents, const std::string& path) {
  for (std::size_t t = 0; t < contents.tables.size(); ++t)
    for (const RecordedColumn& column : contents.tables[t].columns)
      if (column_path(contents.tables[t].name, column.name) == path) return t;
  return std::nullopt;
}

/// The first table where the experiment names none: that of the first sensor whose column exists.
std::size_t likely_table(const RecordingContents& contents, const std::vector<std::string>& wanted) {
  for (const std::string& column : wanted)
    if (const auto table = table_of(contents, column)) return *table;
  return 0;
}

void report_contents(const RecordingContents& contents, FileReport& report) {
  for (const RecordingSentence& one : contents.problems) report.problem("file", one.line, [&] { return one.text; });
  for (const RecordingSentence& one : contents.remarks) report.note("file", one.line, [&] { return one.text; });
  if (contents.problems.empty() && contents.tables.empty())
    report.problem("file", 0, [] { return std::string(kNoNumbers); });
}

std::optional<OpenedTables> open_tables(const std::string& table, const std::vector<std::string>& wanted,
                                        bool needs_table, const RecordingFormats& formats, OpenedFile& file) {
  if (const std::string reason = why_no_file(file.path); !reason.empty()) {
    file.report.problem("file", 0, [&] { return reason; });
    return std::nullopt;
  }
  OpenedTables opened{formats.contents(file.path)};
  report_contents(opened.contents, file.report);
  if (file.report.has_problems()) return std::nullopt;
  const std::vector<std::string> names = names_of_tables(opened.contents);
  const auto named = table_named(opened.contents, table);
  if (named || (table.empty() && (!needs_table || names.size() == 1))) {
    opened.first = named ? *named : likely_table(opened.contents, wanted);
    take_table(opened.contents, opened.first, file);
    return opened;
  }
  file.report.problem("table", 0, [&] {
    if (table.empty()) return fmt::format("has several tables; give table = \"...\", one of {}", listed(names));
    return fmt::format("no table `{}`{}; the tables are {}", excerpt(table), did_you_mean(table, names), listed(names));
  });
  return std::nullopt;
}

void check_format(const RecordingSource& source, const RecordingPlan& plan, const CsvFormat& format,
                  FileReport& report) {
  if (report.has_problems()) return;
  check_units(plan, format, report);
  note_unread_drives(source, format, report);
}

/// The columns of one of the runs side by side in a file, with their names in its table.
void take_run(const std::string& run, OpenedFile& file) {
  if (std::ranges::find(file.runs, run) == file.runs.end()) {
    file.report.problem("table", file.format.header_line, [&] {
      if (file.runs.empty())
        return fmt::format("no table `{}`: no column name ends with the number of a run; leave table out",
                           excerpt(run));
      return fmt::format("no table `{}`{}; the runs in its header are {}", excerpt(run), did_you_mean(run, file.runs),
                         listed(file.runs));
    });
    return;
  }
  file.run = run;
  file.shares_clock =
      file.runs.size() > 1 && std::ranges::find(file.format.names, file.time_column) != file.format.names.end();
  file.format.names = names_of_run(file.format.names, run);
}

/// Runs of a file that no recording of the experiment reads; reported where the file is named first.
void note_unread_runs(const RecordingSource& source, const MeasuredFile& file, OpenedFile& opened) {
  const auto first = std::ranges::find(source.files, file.path, &MeasuredFile::path);
  if (&*first != &file) return;
  std::vector<std::string> unread = opened.runs;
  std::erase(unread, name_and_run(opened.time_column).run);
  for (const ColumnMapping& sensor : source.sensors) std::erase(unread, name_and_run(sensor.column).run);
  for (const MeasuredFile& other : source.files)
    if (other.path == file.path) std::erase(unread, other.table);
  if (unread.empty()) return;
  opened.report.note("runs", opened.format.header_line, [&] {
    return fmt::format(
        "the runs in this file are {}; not read: {}. To read a run, write [[target.recording]] with this "
        "file and table = \"{}\"",
        listed(opened.runs), listed(unread), unread.front());
  });
}

/// `run`: of a file that has several side by side; empty: its columns have their whole names.
void open_csv(const RecordingSource& source, const RecordingPlan& plan, const std::string& run, OpenedFile& file) {
  file.text = read_measured_text(file.path, file.report);
  if (file.report.has_problems()) return;
  file.format = find_csv_format(file.text, {file.time_column, source.delimiter, source.decimal_comma}, file.report);
  file.runs = runs_in(file.format.names);
  if (!run.empty() && !file.report.has_problems()) take_run(run, file);
  file.columns = NameIndex(file.format.names);
  check_format(source, plan, file.format, file.report);
}

/// The other tables of the first file, as further files of the recording with the first one's clock.
void add_found_tables(const OpenedTables& opened, OpenedRecording& recording) {
  const std::filesystem::path path = recording.tables.front().path;
  for (std::size_t t = 0; t < opened.contents.tables.size(); ++t) {
    const std::string& name = opened.contents.tables[t].name;
    const bool is_there = t == opened.first || std::any_of(recording.file.with.begin(), recording.file.with.end(),
                                                           [&](const FurtherFile& further) {
                                                             return further.path == path && further.table == name;
                                                           });
    if (is_there) continue;
    const OpenedFile& first = recording.tables.front();
    OpenedFile table{path, FileReport(path.string()), first.time_column, first.time_unit, {}, {}};
    table.is_found = true;
    take_table(opened.contents, t, table);
    FurtherFile further;
    further.path = path;
    further.table = name;
    further.time_column = table.time_column;
    further.time_unit = table.time_unit;
    further.location = recording.file.location;
    recording.file.with.push_back(std::move(further));
    recording.tables.push_back(std::move(table));
  }
}

void drop_tables_without(const std::vector<std::string>& wanted, OpenedRecording& recording) {
  for (std::size_t t = recording.tables.size(); t-- > 1;) {
    const OpenedFile& table = recording.tables[t];
    const bool is_wanted =
        std::any_of(wanted.begin(), wanted.end(), [&](const std::string& name) { return table.has(name); });
    if (!table.is_found || is_wanted) continue;
    recording.tables.erase(recording.tables.begin() + static_cast<std::ptrdiff_t>(t));
    recording.file.with.erase(recording.file.with.begin() + static_cast<std::ptrdiff_t>(t) - 1);
  }
}

/// Rules for joined files (config/schema/recording_schema.cpp) also apply to joined tables.
void check_found_tables(const RecordingSource& source, OpenedRecording& recording) {
  if (source.trial_column.empty() && source.controllers.empty()) return;
  for (const OpenedFile& table : recording.tables) {
    if (!table.is_found) continue;
    recording.tables.front().report.problem("tables", 0, [&] {
      return fmt::format("the columns are in the tables {} and {}, which are joined; this excludes {}",
                         *recording.tables.front().table, *table.table,
                         source.trial_column.empty() ? "target.controllers" : "trial_column");
    });
    return;
  }
}

void open_further(const RecordingSource& source, const RecordingPlan& plan, const FurtherFile& further,
                  const std::vector<std::string>& wanted, const RecordingFormats* formats, OpenedRecording& recording) {
  OpenedFile& file =
      recording.tables.emplace_back(OpenedFile{further.path,
                                               FileReport(further.path.string()),
                                               further.time_column.empty() ? source.time_column : further.time_column,
                                               further.time_unit.empty() ? source.time_unit : further.time_unit,
                                               {},
                                               further.columns});
  if (!formats || !formats->reads(file.path)) return open_csv(source, plan, further.table, file);
  const auto opened = open_tables(further.table, wanted, true, *formats, file);
  if (opened) check_format(source, plan, format_of_all(opened->contents), file.report);
}

}  // namespace

std::string column_path(const std::string& table, const std::string& column) {
  return table.empty() ? column : table + "." + column;
}

std::string OpenedFile::own_name(const std::string& column) const {
  if (!run.empty())
    return column.starts_with(column_path(run, "")) ? column.substr(run.size() + 1) : name_in_run(column, run);
  if (!table || table->empty()) return column;
  const std::string start = column_path(*table, "");
  if (column.starts_with(start)) return column.substr(start.size());
  return is_found && column != time_column ? std::string() : column;
}

bool OpenedFile::is_named(const std::string& column) const {
  return std::find(only.begin(), only.end(), column) != only.end();
}

bool OpenedRecording::has_problems() const {
  return std::any_of(tables.begin(), tables.end(), [](const OpenedFile& one) { return one.report.has_problems(); });
}

OpenedRecording open_recording(const RecordingSource& source, const RecordingPlan& plan, const MeasuredFile& file,
                               const std::vector<std::string>& wanted, const RecordingFormats* formats) {
  OpenedRecording recording{file, {}};
  OpenedFile& first = recording.tables.emplace_back(OpenedFile{
      file.path, FileReport(file.path.string()), source.time_column, source.time_unit, source.time_encoding, {}});
  std::optional<OpenedTables> opened;
  if (formats && formats->reads(file.path)) {
    opened = open_tables(file.table, wanted, false, *formats, first);
    if (opened) check_format(source, plan, format_of_all(opened->contents), first.report);
  } else {
    open_csv(source, plan, file.table, first);
    note_unread_runs(source, file, first);
  }
  for (const FurtherFile& further : file.with) open_further(source, plan, further, wanted, formats, recording);
  if (opened) add_found_tables(*opened, recording);
  drop_tables_without(wanted, recording);
  check_found_tables(source, recording);
  return recording;
}

}  // namespace lacuna
