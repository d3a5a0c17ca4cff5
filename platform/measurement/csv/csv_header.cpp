#include "measurement/csv/csv_header.h"

#include "measurement/names/column_name.h"
#include "measurement/names/column_words.h"
#include "measurement/csv/csv_lines.h"
#include "measurement/cells/date_stamp.h"
#include "measurement/names/header_names.h"
#include "measurement/cells/number_cell.h"
#include "measurement/cells/utf8.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace lacuna {
namespace {

constexpr std::array kDelimiters = {';', '\t', ',', '|', ' '};
constexpr std::size_t kRowsOfNumbers = 3;  ///< consecutive lines where samples begin; fewer at a file's end

bool is_empty(const std::string& cell) { return cell.empty(); }

std::size_t count_without_empty_end(const std::vector<std::string>& cells) {
  const auto last = std::find_if_not(cells.rbegin(), cells.rend(), is_empty);
  return static_cast<std::size_t>(cells.rend() - last);
}

/// Whether cells look like those of a sample: numbers, dates, empty, and at most one text in three.
bool is_sample(const std::vector<std::string>& cells) {
  std::size_t numbers = 0, texts = 0;
  for (const std::string& cell : cells) {
    if (is_number_in_any_notation(cell) || read_date_stamp(cell))
      ++numbers;
    else if (read_number(cell, false).kind == CellKind::text)
      ++texts;
  }
  return cells.size() > 1 && numbers > 0 && 3 * texts <= cells.size();
}

bool has_no_number(const std::vector<std::string>& cells) {
  return std::none_of(cells.begin(), cells.end(),
                      [](const std::string& cell) { return is_number_in_any_notation(cell); });
}

/// Line where the samples begin, and their number of cells.
struct FirstSamples {
  std::size_t index = 0, width = 0, fewest = 0;  ///< `fewest`: cells without the empty ones at the end
};

/// The first consecutive lines that are all samples of one width.
FirstSamples first_samples(const std::vector<std::vector<std::string>>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t end = std::min(i + kRowsOfNumbers, cells.size());
    FirstSamples found{i, cells[i].size(), cells[i].size()};
    bool all = true;
    for (std::size_t k = i; k < end && all; ++k) {
      all = cells[k].size() == found.width && is_sample(cells[k]);
      found.fewest = std::min(found.fewest, count_without_empty_end(cells[k]));
    }
    if (all) return found;
  }
  return {};
}

/// Number of names with known words or units.
std::size_t known_names(const std::vector<std::string>& names) {
  return static_cast<std::size_t>(std::count_if(names.begin(), names.end(), [](const std::string& name) {
    return role_in_words(words_of(name)) || !unit_in_name(name).empty();
  }));
}

/// Of the lines above the samples with the same width that are not a row of units, the one with most known names; of
/// several the last. Nothing where there are no samples, or nothing above them can be a header.
std::optional<std::size_t> header_above(const std::vector<std::vector<std::string>>& cells) {
  const FirstSamples samples = first_samples(cells);
  std::optional<std::size_t> header;
  std::size_t most = 0;
  for (std::size_t index = samples.index; index-- > 0;) {
    const std::size_t names = count_without_empty_end(cells[index]);
    if (names < samples.fewest || names > samples.width || !has_no_number(cells[index])) continue;
    const std::size_t known = known_names(cells[index]);
    if (!units_in_row(cells[index]).empty() || (header && known <= most)) continue;
    header = index;
    most = known;
  }
  return header;
}

/// Whether a column has this name, with or without the number of its run (csv_runs.h).
bool names(const std::vector<std::string>& cells, const std::string& column) {
  return std::any_of(cells.begin(), cells.end(), [&](const std::string& cell) {
    return cell == column || (cell.size() > column.size() && name_and_run(cell).text == column);
  });
}

}  // namespace

std::vector<std::string> cells_of(std::string_view line, char delimiter) {
  CellSplitter splitter(delimiter);
  splitter.split(line);
  std::vector<std::string> cells;
  for (const std::string_view cell : splitter.cells())
    cells.push_back(is_utf8(cell) ? std::string(trimmed(cell)) : utf8_from_latin1(trimmed(cell)));
  return cells;
}

bool is_number_in_any_notation(std::string_view cell) {
  return read_number(cell, false).kind == CellKind::number || read_number(cell, true).kind == CellKind::number;
}

std::size_t header_among(const std::vector<NumberedLine>& lines, const CsvFormatHints& hints) {
  const std::string& time = hints.time_column;
  std::optional<std::size_t> above;
  std::size_t named = lines.size();
  for (const char delimiter : kDelimiters) {
    if (hints.delimiter != '\0' && delimiter != hints.delimiter) continue;
    std::vector<std::vector<std::string>> cells;
    for (const NumberedLine& line : lines) cells.push_back(cells_of(line.text, delimiter));
    const std::optional<std::size_t> header = header_above(cells);
    if (!time.empty() && header && names(cells[*header], time)) return *header;
    if (!above) above = header;
    for (std::size_t i = 0; i < named && !time.empty(); ++i)
      if (names(cells[i], time)) named = i;
  }
  return named < lines.size() ? named : above.value_or(0);
}

std::vector<std::string> units_in_row(const std::vector<std::string>& cells) {
  std::vector<std::string> units;
  std::size_t known = 0, unknown = 0;
  for (const std::string& cell : cells) {
    if (cell != "1" && is_number_in_any_notation(cell)) return {};
    units.push_back(unit_of_cell(cell));
    const bool says_something = std::any_of(cell.begin(), cell.end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80;
    });
    known += units.back().empty() || cell == "1" ? 0 : 1;
    unknown += units.back().empty() && says_something ? 1 : 0;
  }
  return cells.size() > 1 && known > unknown ? units : std::vector<std::string>{};
}

}  // namespace lacuna
