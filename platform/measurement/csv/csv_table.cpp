#include "measurement/csv/csv_table.h"

#include "foundation/name_index.h"
#include "measurement/csv/csv_lines.h"
#include "measurement/csv/cut_number.h"
#include "measurement/cells/number_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace lacuna {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// One pass over the rows. Separate from its result, so that the per-column memory is here.
class TableReader {
 public:
  TableReader(const CsvFormat& format, const CsvQuery& query, FileReport& report)
      : format_(format),
        query_(query),
        report_(report),
        splitter_(format.delimiter),
        time_reader_(format.decimal_comma) {
    const NameIndex names(format.names);
    const auto index_of = [&](const std::string& name) { return names.find(name).value_or(format.names.size()); };
    time_index_ = index_of(query.time_column);
    if (!query.trial_column.empty()) trial_index_ = index_of(query.trial_column);
    if (!query.fraction_column.empty()) fraction_index_ = index_of(query.fraction_column);
    for (const WantedColumn& column : query.columns) {
      indices_.push_back(index_of(column.name));
      first_missing_.push_back(0);
      missing_.push_back(0);
    }
    table_.columns.resize(query.columns.size());
  }

  CsvTable read(std::string_view text) {
    reserve(text);
    text_ = text;
    LineReader reader(text);
    std::string_view line;
    int number = 0;
    while (reader.next(line, number)) {
      if (number < format_.first_line || is_skipped_line(line)) continue;
      read_row(line, number, reader.at_cut_end());
    }
    table_.time_origin = time_reader_.origin();
    table_.dated = time_reader_.dated();
    table_.period = time_reader_.period();
    if (table_.dated && !table_.times.empty()) table_.first_date = table_.times.front();
    add_fractions();
    note_missing();
    return std::move(table_);
  }

 private:
  /// Rows are about as long as the middle one. A little spare memory stays allocated, but growing by doubling would
  /// touch twice the memory.
  void reserve(std::string_view text) {
    const std::size_t middle = text.size() / 2;
    const std::size_t start = text.find('\n', middle);
    const std::size_t end = start == text.npos ? text.npos : text.find('\n', start + 1);
    if (end == text.npos) return;
    const std::size_t rows = text.size() / (end - start) * 17 / 16 + 16;
    table_.times.reserve(rows);
    table_.lines.reserve(rows);
    for (std::vector<double>& column : table_.columns) column.reserve(rows);
  }

  void read_row(std::string_view line, int number, bool cut) {
    if (line.find('\0') != line.npos) {
      report_.problem("zero bytes", number, [] {
        return std::string("zero bytes, as after a power loss of the logger; delete the file from this line on");
      });
      return;
    }
    if (splitter_.split(line) == CellSplitter::Result::open_quote) {
      report_.problem("quotes", number, [] {
        return std::string("a quoted cell is not closed on its line; cells with line breaks cannot be read");
      });
      return;
    }
    if (has_right_size(number, cut)) take_cells(number);
  }

  bool has_right_size(int number, bool cut) {
    const std::size_t cells = splitter_.cells().size();
    const std::size_t names = format_.names.size();
    if (cells == names) return !cut || !is_cut_off(number);
    const auto beyond = splitter_.cells().begin() + static_cast<std::ptrdiff_t>(std::min(names, cells));
    if (cells > names &&
        std::all_of(beyond, splitter_.cells().end(), [](std::string_view cell) { return trimmed(cell).empty(); }))
      return true;  // delimiters at the end of the line
    if (cells < names && query_.has_other_runs && !cut) {
      splitter_.fill_up(names);  // runs that have ended
      return true;
    }
    if (cells < names && cut) {
      report_.doubt("cut", number,
                    [] { return std::string("the file ends in the middle of its last line, which is left out"); });
      return false;
    }
    report_.problem("size", number, [&] { return wrong_size(cells, names); });
    return false;
  }

  bool is_cut_off(int number) {
    if (!ends_in_cut_number(text_, format_)) return false;
    report_.doubt("cut", number, [&] {
      return fmt::format(
          "the file ends in the middle of a line: its last number, `{}`, has fewer digits than all numbers above it; "
          "the line is left out",
          excerpt(trimmed(splitter_.cells().back())));
    });
    return true;
  }

  std::string wrong_size(std::size_t cells, std::size_t names) const {
    std::string message =
        fmt::format("{} cells, but the header (line {}) has {} names", cells, format_.header_line, names);
    if (format_.delimiter == ',' && cells > names)
      message += "; with decimal commas the cells must be separated by semicolons or tabs";
    if (cells < names) message += "; complete the row, with empty cells where nothing was measured, or delete it";
    return message;
  }

  void take_cells(int number) {
    const std::vector<std::string_view>& cells = splitter_.cells();
    if (query_.has_other_runs && is_beyond_run(cells)) return;
    const NumberCell time = time_reader_.read(cells[time_index_]);
    if (time.kind != CellKind::number) {
      report_.problem("time", number, [&] { return bad_cell(query_.time_column, cells[time_index_], time.kind); });
      return;
    }
    if (!query_.trial_column.empty() && trimmed(cells[trial_index_]).empty()) {
      report_.problem("trial", number,
                      [&] { return fmt::format("the trial column `{}` is empty here", query_.trial_column); });
      return;
    }
    table_.times.push_back(time.value);
    if (!query_.fraction_column.empty()) fractions_.push_back(fraction_of(cells));
    table_.lines.push_back(number);
    if (!query_.trial_column.empty()) table_.trials.push_back(trial_number(trimmed(cells[trial_index_])));
    for (std::size_t i = 0; i < indices_.size(); ++i) table_.columns[i].push_back(value(i, cells[indices_[i]], number));
  }

  /// Whether only other runs have values in a row.
  bool is_beyond_run(const std::vector<std::string_view>& cells) const {
    if (!query_.shared_clock && !trimmed(cells[time_index_]).empty()) return false;
    return std::all_of(indices_.begin(), indices_.end(),
                       [&](std::size_t index) { return trimmed(cells[index]).empty(); });
  }

  /// The fraction of a second from its separate column; NaN where it is invalid.
  double fraction_of(const std::vector<std::string_view>& cells) const {
    const double seconds = read_number(cells[fraction_index_], format_.decimal_comma).value * query_.fraction_unit;
    return seconds >= 0.0 && seconds < 1.0 ? seconds : kNan;
  }

  /// Adds fractions of a second, if all are valid, to whole seconds.
  void add_fractions() {
    const auto is_whole = [](double time) { return time == std::round(time); };
    table_.has_fractions =
        !fractions_.empty() && std::all_of(table_.times.begin(), table_.times.end(), is_whole) &&
        std::none_of(fractions_.begin(), fractions_.end(), [](double one) { return std::isnan(one); });
    for (std::size_t i = 0; table_.has_fractions && i < fractions_.size(); ++i) table_.times[i] += fractions_[i];
  }

  double value(std::size_t column, std::string_view cell, int number) {
    const NumberCell read = read_number(cell, format_.decimal_comma);
    if (read.kind == CellKind::number) return read.value;
    const WantedColumn& wanted = query_.columns[column];
    if (read.kind == CellKind::missing && wanted.may_be_missing) {
      if (missing_[column]++ == 0) first_missing_[column] = number;
    } else {
      report_.problem(wanted.name, number, [&] { return bad_cell(wanted.name, cell, read.kind); });
    }
    return kNan;
  }

  std::string bad_cell(const std::string& name, std::string_view cell, CellKind kind) const {
    if (kind == CellKind::missing)
      return fmt::format("column `{}` has no value here (`{}`) but needs one in every row", name,
                         excerpt(trimmed(cell)));
    if (kind == CellKind::infinite)
      return fmt::format("column `{}` has `{}`; leave the cell empty where nothing was measured", name,
                         excerpt(trimmed(cell)));
    std::string message = fmt::format("column `{}` has `{}` instead of a number", name, excerpt(trimmed(cell)));
    const std::size_t length = message.size();
    if (!format_.decimal_comma && read_number(cell, true).kind == CellKind::number)
      message += "; for a decimal comma, all numbers of the file must have one";
    if (format_.decimal_comma && read_number(cell, false).kind == CellKind::number)
      message += "; numbers of this file have decimal commas";
    if (message.size() == length) message += "; empty the cell if nothing was measured, or delete the row";
    return message;
  }

  int trial_number(std::string_view name) {
    if (!table_.trials.empty() && table_.trial_names[static_cast<std::size_t>(table_.trials.back())] == name)
      return table_.trials.back();
    const auto [place, is_new] = trial_numbers_.try_emplace(std::string(name), static_cast<int>(trial_numbers_.size()));
    if (is_new) table_.trial_names.emplace_back(name);
    return place->second;
  }

  void note_missing() {
    for (std::size_t i = 0; i < missing_.size(); ++i) {
      if (missing_[i] == 0) continue;
      report_.note("missing", first_missing_[i], [&] {
        return fmt::format(
            "column `{}` has no value in {} of {} rows, the first of them here; these count as not measured",
            query_.columns[i].name, missing_[i], table_.times.size());
      });
    }
  }

  const CsvFormat& format_;
  const CsvQuery& query_;
  FileReport& report_;
  std::string_view text_;
  CellSplitter splitter_;
  TimeStampReader time_reader_;
  std::size_t time_index_ = 0;
  std::size_t trial_index_ = 0;
  std::size_t fraction_index_ = 0;
  std::vector<double> fractions_;  ///< s, by row
  std::vector<std::size_t> indices_;
  std::vector<int> first_missing_;
  std::vector<std::size_t> missing_;
  std::map<std::string, int> trial_numbers_;
  CsvTable table_;
};

}  // namespace

CsvTable read_csv_table(std::string_view text, const CsvFormat& format, const CsvQuery& query, FileReport& report) {
  return TableReader(format, query, report).read(text);
}

}  // namespace lacuna
