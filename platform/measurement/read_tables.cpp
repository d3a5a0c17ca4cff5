#include "measurement/read_tables.h"

#include "foundation/name_index.h"
#include "foundation/unit.h"
#include "measurement/clock_wraps.h"
#include "measurement/csv_format.h"
#include "measurement/decode_tables.h"
#include "measurement/join_tables.h"
#include "measurement/measured_text.h"
#include "measurement/plausibility.h"
#include "measurement/unread_drives.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace lacuna {
namespace {

/// A file whose header is known.
struct OpenedFile {
  std::filesystem::path path;
  FileReport report;
  std::string time_column;
  std::string time_unit;
  Encoding time_encoding;
  std::vector<std::string> only;  ///< the columns to be taken from it; empty: those that are wanted
  std::string text = {};
  CsvFormat format = {};
  NameIndex columns = {};               ///< of the format's names
  std::vector<std::size_t> given = {};  ///< which of the wanted columns it gives
  std::set<std::string> told = {};      ///< columns whose absence was told

  bool has(const std::string& name) const { return columns.count(name) > 0; }
  bool is_named(const std::string& name) const { return std::find(only.begin(), only.end(), name) != only.end(); }
};

std::vector<std::string> names_of_columns(const RecordingPlan& plan) {
  std::vector<std::string> names;
  for (const PlannedColumn* column : columns_of(plan)) names.push_back(column->mapping->column);
  for (const PlannedSwitch& one : plan.switches) names.push_back(one.column);
  return names;
}

void open(const RecordingSource& source, const RecordingPlan& plan, OpenedFile& file) {
  file.text = read_measured_text(file.path, file.report);
  if (file.report.has_problems()) return;
  file.format = find_csv_format(file.text, {file.time_column, source.delimiter, source.decimal_comma}, file.report);
  file.columns = NameIndex(file.format.names);
  if (file.report.has_problems()) return;
  check_units(plan, file.format, file.report);
  note_unread_drives(source, file.format, file.report);
}

std::vector<OpenedFile> open_files(const RecordingSource& source, const RecordingPlan& plan, const MeasuredFile& file) {
  std::vector<OpenedFile> files = {
      {file.path, FileReport(file.path.string()), source.time_column, source.time_unit, source.time_encoding, {}}};
  for (const FurtherFile& further : file.with)
    files.push_back({further.path,
                     FileReport(further.path.string()),
                     further.time_column.empty() ? source.time_column : further.time_column,
                     further.time_unit.empty() ? source.time_unit : further.time_unit,
                     {},
                     further.columns});
  for (OpenedFile& one : files) open(source, plan, one);
  return files;
}

/// Columns that are not there are the experiment's mistake as often as the file's: the line says both.
void check_column(const std::string& name, OpenedFile& file) {
  const std::vector<std::string>& names = file.format.names;
  const std::size_t count = file.columns.count(name);
  if (count == 1 || !file.told.insert(name).second) return;
  file.report.problem("column " + name, file.format.header_line, [&] {
    if (count > 1) return fmt::format("{} columns are called `{}`; rename all but one", count, excerpt(name));
    return fmt::format("no column `{}`{}; the columns are {}", excerpt(name), did_you_mean(name, names), listed(names));
  });
}

/// What an entry of `with` names must be there, and be read.
void check_named(const std::string& name, const std::vector<std::string>& wanted, OpenedFile& file) {
  if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) return check_column(name, file);
  file.report.problem("named " + name, 0, [&] {
    return fmt::format("columns names `{}`{}, which the experiment does not read from any file; it reads {}",
                       excerpt(name), did_you_mean(name, wanted), listed(wanted));
  });
}

/// The file that a column is taken from: the one that names it, else the first, else the only other one that has it.
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
      return fmt::format("column `{}` is also {} {}; let columns = [...] of one file alone name it", excerpt(name),
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

/// Seconds and parts of them in two columns are one time stamp.
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

/// Empties the file's text, which is of no more use. Without `allotted` columns there is nothing to be read.
ReadTable read_table(const RecordingSource& source, const std::vector<std::string>& wanted, bool allotted,
                     OpenedFile& file) {
  ReadTable read{std::move(file.report), {}};
  const std::string text = std::move(file.text);
  read.table.columns.resize(wanted.size());
  if (read.report.has_problems() || !allotted) return read;
  CsvQuery query;
  query.time_column = file.time_column;
  query.trial_column = source.trial_column;
  const std::optional<Unit> unit = parse_unit(file.time_unit);
  const double seconds_per_unit = unit ? unit->to_si : 1.0;
  name_fraction(file, seconds_per_unit, query);
  for (const std::size_t c : file.given) query.columns.push_back({wanted[c]});
  read.table = read_csv_table(text, file.format, query, read.report);
  if (read.table.has_fractions) note_fraction(file, query, read.report);
  std::vector<std::vector<double>> columns(wanted.size());
  for (std::size_t i = 0; i < file.given.size(); ++i) columns[file.given[i]] = std::move(read.table.columns[i]);
  read.table.columns = std::move(columns);
  if (!read.report.has_problems()) decode_clock({file.time_column, file.time_encoding, seconds_per_unit}, read);
  return read;
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

std::vector<ReadRecording> read_tables(const RecordingSource& source, const RecordingPlan& plan) {
  const std::vector<std::string> wanted = names_of_columns(plan);
  std::vector<ReadTable> tables;
  for (const MeasuredFile& file : source.files) {
    std::vector<OpenedFile> files = open_files(source, plan, file);
    const bool all_open =
        std::none_of(files.begin(), files.end(), [](const OpenedFile& one) { return one.report.has_problems(); });
    if (all_open) allot_columns(wanted, source.trial_column, files);
    for (OpenedFile& one : files) tables.push_back(read_table(source, wanted, all_open, one));
  }
  decode_tables(plan, tables);
  std::vector<ReadRecording> recordings;
  auto next = std::make_move_iterator(tables.begin());
  for (const MeasuredFile& file : source.files) {
    const auto end = next + static_cast<std::ptrdiff_t>(file.with.size()) + 1;
    recordings.push_back(join_tables(source, plan, file, std::vector<ReadTable>(next, end)));
    next = end;
  }
  return recordings;
}

}  // namespace lacuna
