#include "measurement/trials/foreign_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace lacuna {
namespace {

constexpr double kNoReading = std::numeric_limits<double>::quiet_NaN();

/// Of a file with problems: all columns, without rows.
CsvTable empty_table(const CsvQuery& query) {
  CsvTable table;
  table.columns.resize(query.columns.size());
  return table;
}

/// Makes a table of the rows of one query.
class RowTable {
 public:
  RowTable(const RecordedRows& rows, const CsvQuery& query, FileReport& report)
      : rows_(rows), query_(query), report_(report), asked_(rows_query(query, "").columns) {}

  CsvTable make() {
    if (!is_whole()) return empty_table(query_);
    find_rows();
    table_.time_origin = rows_.origins[place_of(query_.time_column)];
    take_times();
    take_trials();
    for (const WantedColumn& wanted : query_.columns) table_.columns.push_back(column_of(wanted.name));
    add_fractions();
    return std::move(table_);
  }

 private:
  std::size_t place_of(const std::string& name) const {
    return static_cast<std::size_t>(std::find(asked_.begin(), asked_.end(), name) - asked_.begin());
  }
  const std::vector<double>& numbers_of(const std::string& name) const { return rows_.columns[place_of(name)]; }
  int line_of(std::size_t row) const { return row < rows_.lines.size() ? rows_.lines[row] : 0; }

  /// Whether the format returned what was requested.
  bool is_whole() {
    bool whole = rows_.columns.size() == asked_.size() && rows_.origins.size() == asked_.size();
    for (const std::vector<double>& column : rows_.columns)
      whole = whole && column.size() == rows_.columns.front().size();
    whole = whole && (rows_.lines.empty() || rows_.lines.size() == rows_.columns.front().size());
    if (!whole)
      report_.problem("format", 0, [] {
        return std::string(
            "the plugin that reads this format returned other columns than requested; repair the plugin");
      });
    return whole;
  }

  /// The rows with a time.
  void find_rows() {
    const std::vector<double>& times = numbers_of(query_.time_column);
    std::size_t without = 0, first_without = 0;
    for (std::size_t row = 0; row < times.size(); ++row) {
      if (std::isfinite(times[row])) {
        kept_.push_back(row);
      } else if (has_value(row)) {
        report_.problem("time", line_of(row), [&] {
          return fmt::format("column `{}` has no value in row {} but needs one in every row", query_.time_column,
                             row + 1);
        });
      } else if (without++ == 0) {
        first_without = row;
      }
    }
    if (without == 0) return;
    report_.note("empty rows", line_of(first_without), [&] {
      return fmt::format(
          "{} of {} rows have neither a time nor any of the columns, the first is row {}; these rows are left out",
          without, times.size(), first_without + 1);
    });
  }

  bool has_value(std::size_t row) const {
    return std::any_of(rows_.columns.begin(), rows_.columns.end(),
                       [&](const std::vector<double>& column) { return !std::isnan(column[row]); });
  }

  void take_times() {
    const std::vector<double>& times = numbers_of(query_.time_column);
    for (const std::size_t row : kept_) {
      table_.times.push_back(times[row]);
      table_.lines.push_back(line_of(row));
    }
  }

  void take_trials() {
    if (query_.trial_column.empty()) return;
    const std::vector<double>& numbers = numbers_of(query_.trial_column);
    const double origin = rows_.origins[place_of(query_.trial_column)];
    std::map<double, int> known;
    for (const std::size_t row : kept_) {
      if (!std::isfinite(numbers[row])) {
        report_.problem("trial", line_of(row), [&] {
          return fmt::format("the trial column `{}` has no value in row {}", query_.trial_column, row + 1);
        });
        continue;
      }
      const auto [place, is_new] = known.try_emplace(numbers[row], static_cast<int>(known.size()));
      if (is_new) table_.trial_names.push_back(fmt::format("{:.15g}", origin + numbers[row]));
      table_.trials.push_back(place->second);
    }
  }

  std::vector<double> column_of(const std::string& name) {
    const std::vector<double>& numbers = numbers_of(name);
    const double origin = rows_.origins[place_of(name)];
    std::vector<double> column;
    column.reserve(kept_.size());
    std::size_t missing = 0, first_missing = 0;
    for (const std::size_t row : kept_) {
      column.push_back(origin + numbers[row]);
      if (std::isnan(numbers[row]) && missing++ == 0) first_missing = row;
      if (std::isinf(numbers[row]))
        report_.problem(name, line_of(row), [&] {
          return fmt::format("column `{}` is infinite in row {}; leave the value out where nothing was measured", name,
                             row + 1);
        });
    }
    if (missing > 0)
      report_.note("missing", line_of(first_missing), [&] {
        return fmt::format(
            "column `{}` has no value in {} of {} rows, the first is row {}; these count as not measured", name,
            missing, kept_.size(), first_missing + 1);
      });
    return column;
  }

  /// Adds fractions of a second, if all are valid, to whole seconds.
  void add_fractions() {
    if (query_.fraction_column.empty()) return;
    const std::vector<double>& parts = numbers_of(query_.fraction_column);
    const double origin = rows_.origins[place_of(query_.fraction_column)];
    std::vector<double> fractions;
    for (const std::size_t row : kept_) fractions.push_back((origin + parts[row]) * query_.fraction_unit);
    table_.has_fractions = !fractions.empty() && std::all_of(table_.times.begin(), table_.times.end(), [](double time) {
      return time == std::round(time);
    }) && std::all_of(fractions.begin(), fractions.end(), [](double part) { return part >= 0.0 && part < 1.0; });
    for (std::size_t i = 0; table_.has_fractions && i < fractions.size(); ++i) table_.times[i] += fractions[i];
  }

  const RecordedRows& rows_;
  const CsvQuery& query_;
  FileReport& report_;
  std::vector<std::string> asked_;
  std::vector<std::size_t> kept_;
  CsvTable table_;
};

}  // namespace

TableQuery rows_query(const CsvQuery& query, const std::string& table) {
  TableQuery asked{table, {query.time_column}};
  const auto ask = [&](const std::string& column) {
    if (!column.empty() && std::find(asked.columns.begin(), asked.columns.end(), column) == asked.columns.end())
      asked.columns.push_back(column);
  };
  ask(query.trial_column);
  ask(query.fraction_column);
  for (const WantedColumn& column : query.columns) ask(column.name);
  return asked;
}

CsvTable table_of_rows(RecordedRows rows, const CsvQuery& query, FileReport& report) {
  if (report.has_problems()) return empty_table(query);
  return RowTable(rows, query, report).make();
}

void report_reading(const ReadRows& read, FileReport& report) {
  for (const RecordingSentence& one : read.problems) report.problem("reading", one.line, [&] { return one.text; });
  for (const RecordingSentence& one : read.doubts) report.doubt("reading doubt", one.line, [&] { return one.text; });
  for (const RecordingSentence& one : read.remarks) report.note("reading", one.line, [&] { return one.text; });
}

}  // namespace lacuna
