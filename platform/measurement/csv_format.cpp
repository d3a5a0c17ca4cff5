#include "measurement/csv_format.h"

#include "measurement/column_name.h"
#include "measurement/csv_lines.h"
#include "measurement/number_cell.h"
#include "measurement/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lacuna {
namespace {

constexpr int kLinesAboveHeader = 60;

struct Line {
  std::string_view text;
  int number = 0;
};

std::vector<std::string> split_names(std::string_view line, char delimiter) {
  CellSplitter splitter(delimiter);
  splitter.split(line);
  std::vector<std::string> names;
  for (const std::string_view cell : splitter.cells()) names.emplace_back(trimmed(cell));
  return names;
}

std::size_t cell_count(std::string_view line, char delimiter) { return split_names(line, delimiter).size(); }

bool is_comment(std::string_view line) { return trimmed(line).starts_with('#') || trimmed(line).starts_with('%'); }

std::string_view without_comment_sign(std::string_view line) {
  line = trimmed(line);
  while (line.starts_with('#') || line.starts_with('%')) line.remove_prefix(1);
  return trimmed(line);
}

bool is_number_in_any_notation(std::string_view cell) {
  const CellKind kind = read_number(cell, false).kind;
  return kind == CellKind::number || read_number(cell, true).kind == CellKind::number;
}

/// The first line decides by the delimiter that splits it and the line below into equally many cells.
char find_delimiter(std::string_view header, std::string_view below) {
  constexpr std::array kCandidates = {';', '\t', ',', '|', ' '};
  for (const char candidate : kCandidates) {
    const std::size_t in_header = cell_count(header, candidate);
    const std::size_t in_row = cell_count(below, candidate);
    if (in_header > 1 && (in_row == in_header || in_row == in_header + 1)) return candidate;
  }
  for (const char candidate : kCandidates)
    if (cell_count(header, candidate) > 1) return candidate;
  return ',';
}

bool names_time(std::string_view line, const std::string& time_column) {
  for (const char delimiter : {';', '\t', ',', '|', ' '}) {
    const std::vector<std::string> names = split_names(line, delimiter);
    if (std::find(names.begin(), names.end(), time_column) != names.end()) return true;
  }
  return false;
}

/// The lines up to the header and a little beyond.
class Beginning {
 public:
  explicit Beginning(std::string_view text) {
    LineReader reader(text);
    Line line;
    while (lines_.size() < kLinesAboveHeader && reader.next(line.text, line.number)) {
      if (is_comment(line.text)) last_comment_ = line;
      if (line.number == 1 && line.text.starts_with("sep=") && line.text.size() >= 5) {
        separator_ = line.text[4];
      } else if (!is_skipped_line(line.text)) {
        if (lines_.empty()) comment_above_ = last_comment_;
        lines_.push_back(line);
      }
    }
  }

  const std::vector<Line>& lines() const { return lines_; }
  char separator() const { return separator_; }
  /// The last comment above the first line that is none.
  const Line& comment_above() const { return comment_above_; }
  std::string_view below(std::size_t index) const {
    return index + 1 < lines_.size() ? lines_[index + 1].text : std::string_view();
  }

 private:
  std::vector<Line> lines_;
  Line last_comment_, comment_above_;
  char separator_ = '\0';
};

char chosen_delimiter(const CsvFormatHints& hints, char separator, std::string_view header, std::string_view below) {
  if (hints.delimiter != '\0') return hints.delimiter;
  return separator != '\0' ? separator : find_delimiter(header, below);
}

bool all_numbers(const std::vector<std::string>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](const std::string& cell) {
    return is_number_in_any_notation(cell) || read_number(cell, false).kind != CellKind::text;
  });
}

/// numpy.savetxt writes its header as a comment.
bool take_header_from_comment(const Beginning& beginning, const CsvFormatHints& hints, FileReport& report,
                              CsvFormat& format) {
  const Line& comment = beginning.comment_above();
  if (comment.number == 0) return false;
  const std::string_view names = without_comment_sign(comment.text);
  const std::string_view row = beginning.lines().front().text;
  const char delimiter = chosen_delimiter(hints, beginning.separator(), names, row);
  if (cell_count(names, delimiter) != cell_count(row, delimiter)) return false;
  format.delimiter = delimiter;
  format.names = split_names(names, delimiter);
  format.header_line = comment.number;
  format.first_line = beginning.lines().front().number;
  report.note("header", comment.number, [] { return std::string("the last comment is read as the header"); });
  return true;
}

std::size_t header_index(const Beginning& beginning, const CsvFormatHints& hints, FileReport& report) {
  const std::vector<Line>& lines = beginning.lines();
  if (hints.time_column.empty() || names_time(lines[0].text, hints.time_column)) return 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!names_time(lines[i].text, hints.time_column)) continue;
    report.note("header", lines[i].number, [&] {
      return fmt::format("the header is found here, where `{}` stands; what is above it is skipped", hints.time_column);
    });
    return i;
  }
  return 0;
}

void take_units_row(const Line& line, FileReport& report, CsvFormat& format) {
  const std::vector<std::string> cells = split_names(line.text, format.delimiter);
  if (cells.size() < 2 || cells.size() > format.names.size() + 1 || all_numbers(cells)) return;
  std::vector<std::string> units;
  for (const std::string& cell : cells) {
    units.push_back(unit_of_cell(cell));
    if (units.back().empty() && !cell.empty() && cell != "-") return;
  }
  format.units = std::move(units);
  format.first_line = line.number + 1;
  report.note("units", line.number, [] {
    return std::string("a row of units, skipped; the units that count are those in the experiment file");
  });
}

void make_names_utf8(CsvFormat& format, FileReport& report) {
  for (std::string& name : format.names) {
    if (is_utf8(name)) continue;
    name = utf8_from_latin1(name);
    report.note("latin1", format.header_line, [&] {
      return fmt::format("column names are not UTF-8, but read as Latin-1: `{}`; save the file as UTF-8", name);
    });
  }
}

/// Three digits after a comma may be thousands as well; between commas, where only quoted cells can have
/// one, that counts for nothing.
bool shows_decimal_comma(std::string_view cell, char delimiter) {
  const std::size_t comma = cell.find(',');
  if (comma == cell.npos || read_number(cell, true).kind != CellKind::number) return false;
  return delimiter != ',' || trimmed(cell.substr(comma + 1)).size() != 3;
}

/// Decimal commas where numbers have commas and none has a point.
bool has_decimal_commas(std::string_view text, const CsvFormat& format) {
  LineReader reader(text);
  CellSplitter splitter(format.delimiter);
  Line line;
  int commas = 0;
  for (int seen = 0; seen < kLinesAboveHeader && reader.next(line.text, line.number);) {
    if (line.number < format.first_line || is_skipped_line(line.text)) continue;
    ++seen;
    splitter.split(line.text);
    for (const std::string_view cell : splitter.cells()) {
      if (cell.find('.') != cell.npos && read_number(cell, false).kind == CellKind::number) return false;
      commas += shows_decimal_comma(cell, format.delimiter) ? 1 : 0;
    }
  }
  return commas > 0;
}

}  // namespace

bool is_skipped_line(std::string_view line) {
  line = trimmed(line);
  return line.empty() || line.front() == '#' || line.front() == '%';
}

CsvFormat find_csv_format(std::string_view text, const CsvFormatHints& hints, FileReport& report) {
  const Beginning beginning(text);
  CsvFormat format;
  if (beginning.lines().empty()) {
    report.problem("header", 0, [] {
      return std::string("has no header and no samples; it needs a line with column names and one line a sample");
    });
    return format;
  }
  const std::size_t index = header_index(beginning, hints, report);
  const Line header = beginning.lines()[index];
  format.delimiter = chosen_delimiter(hints, beginning.separator(), header.text, beginning.below(index));
  format.names = split_names(header.text, format.delimiter);
  format.header_line = header.number;
  format.first_line = header.number + 1;
  if (all_numbers(format.names) && !take_header_from_comment(beginning, hints, report, format)) {
    report.problem("header", header.number, [] {
      return std::string("numbers where the column names should be; put a header line such as `t,angle,torque` on top");
    });
    format.names.clear();
    return format;
  }
  while (!format.names.empty() && format.names.back().empty()) format.names.pop_back();
  make_names_utf8(format, report);
  if (index + 1 < beginning.lines().size() && format.first_line > format.header_line)
    take_units_row(beginning.lines()[index + 1], report, format);
  format.decimal_comma = hints.decimal_comma || has_decimal_commas(text, format);
  if (format.decimal_comma && !hints.decimal_comma)
    report.note("commas", 0, [] { return std::string("commas in numbers are read as decimal commas"); });
  return format;
}

}  // namespace lacuna
