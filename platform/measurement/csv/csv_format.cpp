#include "measurement/csv/csv_format.h"

#include "measurement/csv/csv_header.h"
#include "measurement/csv/csv_lines.h"
#include "measurement/cells/number_cell.h"
#include "measurement/cells/utf8.h"
#include "measurement/shared_commas.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lacuna {
namespace {

constexpr int kLinesAboveHeader = 60;

std::size_t cell_count(std::string_view line, char delimiter) { return cells_of(line, delimiter).size(); }

bool is_comment(std::string_view line) { return trimmed(line).starts_with('#') || trimmed(line).starts_with('%'); }

std::string_view without_comment_sign(std::string_view line) {
  line = trimmed(line);
  while (line.starts_with('#') || line.starts_with('%')) line.remove_prefix(1);
  return trimmed(line);
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

/// The lines up to the header and a little beyond.
class Beginning {
 public:
  explicit Beginning(std::string_view text) {
    LineReader reader(text);
    NumberedLine line;
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

  const std::vector<NumberedLine>& lines() const { return lines_; }
  char separator() const { return separator_; }
  /// The last comment before the first line that is not a comment.
  const NumberedLine& comment_above() const { return comment_above_; }
  std::string_view below(std::size_t index) const {
    return index + 1 < lines_.size() ? lines_[index + 1].text : std::string_view();
  }

 private:
  std::vector<NumberedLine> lines_;
  NumberedLine last_comment_, comment_above_;
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
  const NumberedLine& comment = beginning.comment_above();
  if (comment.number == 0) return false;
  const std::string_view names = without_comment_sign(comment.text);
  const std::string_view row = beginning.lines().front().text;
  const char delimiter = chosen_delimiter(hints, beginning.separator(), names, row);
  if (cell_count(names, delimiter) != cell_count(row, delimiter)) return false;
  format.delimiter = delimiter;
  format.names = cells_of(names, delimiter);
  format.header_line = comment.number;
  format.first_line = beginning.lines().front().number;
  report.note("header", comment.number, [] { return std::string("the last comment is used as the header"); });
  return true;
}

std::size_t header_index(const Beginning& beginning, const CsvFormatHints& hints, FileReport& report) {
  const std::size_t index = header_among(beginning.lines(), hints);
  if (index > 0)
    report.note("header", beginning.lines()[index].number,
                [] { return std::string("the header was found in this line; lines above it are skipped"); });
  return index;
}

void take_units_row(const NumberedLine& line, FileReport& report, CsvFormat& format) {
  const std::vector<std::string> cells = cells_of(line.text, format.delimiter);
  if (cells.size() > format.names.size() + 1) return;
  std::vector<std::string> units = units_in_row(cells);
  if (units.empty()) return;
  format.units = std::move(units);
  format.first_line = line.number + 1;
  report.note("units", line.number,
              [] { return std::string("a row of units, skipped; the units in the experiment file are used"); });
}

/// `cells_of` reads Latin-1 where a cell is no UTF-8.
void note_latin1(std::string_view header, const CsvFormat& format, FileReport& report) {
  if (is_utf8(header)) return;
  const auto is_plain = [](const std::string& name) {
    return std::all_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  };
  const auto other = std::find_if_not(format.names.begin(), format.names.end(), is_plain);
  report.note("latin1", format.header_line, [&] {
    return fmt::format("column names are not UTF-8 and are read as Latin-1: `{}`; save the file as UTF-8",
                       other == format.names.end() ? format.names.front() : *other);
  });
}

/// Three digits after a comma may be thousands, too, except behind a lone zero; in comma-separated files, where only
/// quoted cells can contain a comma, this does not matter.
bool shows_decimal_comma(std::string_view cell, char delimiter) {
  cell = trimmed(cell);
  const std::size_t comma = cell.find(',');
  if (comma == cell.npos || read_number(cell, true).kind != CellKind::number) return false;
  const std::string_view whole = cell.substr(0, comma);
  return delimiter != ',' || cell.substr(comma + 1).size() != 3 || whole == "0" || whole == "-0";
}

/// Decimal commas: numbers contain commas and none contains a point.
bool has_decimal_commas(std::string_view text, const CsvFormat& format) {
  LineReader reader(text);
  CellSplitter splitter(format.delimiter);
  NumberedLine line;
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

void refuse_shared_commas(std::string_view text, const CsvFormat& format, FileReport& report) {
  const SharedCommas shared = shared_commas(text, format);
  if (shared.line == 0) return;
  report.problem("shared commas", shared.line, [&] {
    return fmt::format(
        "{} cells where the header (line {}) has {} names, and all are whole numbers: commas seem to be decimal signs "
        "and delimiters at once, so where a value ends is ambiguous. Save the file with decimal points (0.01,0.5); "
        "with decimal commas the cells must be separated by semicolons or tabs (0,01;0,5)",
        shared.cells, format.header_line, format.names.size());
  });
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
      return std::string("has no header and no samples; it needs a line with column names and one line per sample");
    });
    return format;
  }
  const std::size_t index = header_index(beginning, hints, report);
  const NumberedLine header = beginning.lines()[index];
  format.delimiter = chosen_delimiter(hints, beginning.separator(), header.text, beginning.below(index));
  format.names = cells_of(header.text, format.delimiter);
  format.header_line = header.number;
  format.first_line = header.number + 1;
  if (all_numbers(format.names) && !take_header_from_comment(beginning, hints, report, format)) {
    report.problem("header", header.number, [] {
      return std::string("numbers instead of column names; put a header line such as `t,angle,torque` on top");
    });
    format.names.clear();
    return format;
  }
  while (!format.names.empty() && format.names.back().empty()) format.names.pop_back();
  note_latin1(header.text, format, report);
  if (index + 1 < beginning.lines().size() && format.first_line > format.header_line)
    take_units_row(beginning.lines()[index + 1], report, format);
  refuse_shared_commas(text, format, report);
  format.decimal_comma = hints.decimal_comma || has_decimal_commas(text, format);
  if (format.decimal_comma && !hints.decimal_comma)
    report.note("commas", 0, [] { return std::string("commas in numbers are read as decimal commas"); });
  return format;
}

}  // namespace lacuna
