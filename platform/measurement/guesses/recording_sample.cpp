#include "measurement/guesses/recording_sample.h"

#include "measurement/names/column_words.h"
#include "measurement/trials/foreign_table.h"
#include "measurement/csv/measured_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr std::size_t kSampledRows = 20000;

std::size_t count_positions(const RecordedTable& table) {
  return static_cast<std::size_t>(std::count_if(
      table.columns.begin(), table.columns.end(),
      [](const RecordedColumn& column) { return role_in_words(words_of(column.name)) == ColumnRole::position; }));
}

/// The table with most joint positions; of several the first.
std::size_t main_table(const RecordingContents& contents) {
  const auto most = std::max_element(
      contents.tables.begin(), contents.tables.end(),
      [](const RecordedTable& a, const RecordedTable& b) { return count_positions(a) < count_positions(b); });
  return static_cast<std::size_t>(most - contents.tables.begin());
}

std::vector<TableQuery> queries_for(const RecordingContents& contents) {
  std::vector<TableQuery> queries;
  for (const RecordedTable& table : contents.tables) {
    TableQuery& query = queries.emplace_back(TableQuery{table.name, {}, kSampledRows});
    for (const RecordedColumn& column : table.columns) query.columns.push_back(column.name);
  }
  return queries;
}

/// A column's values at the times of another table: the last one before, like a held command.
std::vector<double> held_at(const std::vector<double>& times, const std::vector<double>& own_times,
                            const std::vector<double>& values, double shift) {
  std::vector<double> held;
  std::size_t next = 0;
  for (const double time : times) {
    while (next < own_times.size() && own_times[next] + shift <= time) ++next;
    held.push_back(next == 0 ? std::numeric_limits<double>::quiet_NaN() : values[next - 1]);
  }
  return held;
}

/// A table of the file with its rows and its clock.
struct SampledTable {
  const RecordedTable* table = nullptr;
  const RecordedRows* rows = nullptr;

  std::size_t clock() const {
    const auto is_clock = [&](const RecordedColumn& column) { return column.name == table->time_column; };
    return static_cast<std::size_t>(std::find_if(table->columns.begin(), table->columns.end(), is_clock) -
                                    table->columns.begin());
  }
  bool has_clock() const { return clock() < table->columns.size() && clock() < rows->columns.size(); }
};

double numeric_share_of(const std::vector<double>& values) {
  const auto known = std::count_if(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  return known > 0 ? 1.0 : 0.0;
}

void add_column(const std::string& name, const RecordedColumn& column, std::vector<double> values, FileSample& sample) {
  const bool is_si = column.unit == kSomeSiUnit;
  sample.format.names.push_back(name);
  sample.format.units.push_back(is_si ? "" : column.unit);
  sample.in_si.push_back(is_si);
  sample.numeric_share.push_back(numeric_share_of(values));
  sample.columns.push_back(std::move(values));
}

void add_table(const SampledTable& main, const SampledTable& other, FileSample& sample) {
  const bool is_main = other.table == main.table;
  if (!is_main && !(main.has_clock() && other.has_clock())) return;
  for (std::size_t c = 0; c < other.rows->columns.size(); ++c) {
    const RecordedColumn& column = other.table->columns[c];
    const bool is_clock = other.has_clock() && c == other.clock();
    if (is_clock && !is_main) continue;
    const std::string name = is_clock ? column.name : column_path(other.table->name, column.name);
    if (is_main) {
      add_column(name, column, other.rows->columns[c], sample);
      continue;
    }
    const std::size_t mine = main.clock(), its = other.clock();
    add_column(name, column,
               held_at(main.rows->columns[mine], other.rows->columns[its], other.rows->columns[c],
                       other.rows->origins[its] - main.rows->origins[mine]),
               sample);
  }
}

void report_problems(const std::vector<RecordingSentence>& problems, FileReport& report) {
  for (const RecordingSentence& one : problems) report.problem("file", one.line, [&] { return one.text; });
}

}  // namespace

FileSample sample_recording(const std::filesystem::path& path, const RecordingFormats& formats, FileReport& report) {
  FileSample sample;
  sample.path = path;
  if (const std::string reason = why_no_file(path); !reason.empty()) {
    report.problem("file", 0, [&] { return reason; });
    return sample;
  }
  const RecordingContents contents = formats.contents(path);
  report_problems(contents.problems, report);
  if (contents.tables.empty() && !report.has_problems())
    report.problem("file", 0, [] { return std::string(kNoNumbers); });
  if (report.has_problems()) return sample;
  const ReadRows read = formats.read(path, queries_for(contents));
  report_problems(read.problems, report);
  if (report.has_problems() || read.tables.size() != contents.tables.size()) return sample;
  const std::size_t first = main_table(contents);
  const SampledTable main{&contents.tables[first], &read.tables[first]};
  add_table(main, main, sample);
  for (std::size_t t = 0; t < contents.tables.size(); ++t)
    if (t != first) add_table(main, {&contents.tables[t], &read.tables[t]}, sample);
  return sample;
}

}  // namespace lacuna
