#include "measurement/shared_commas.h"

#include "measurement/csv/csv_lines.h"
#include "measurement/cells/number_cell.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr int kRowsRead = 60;

/// "-12", "007".
bool is_whole(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
  return !cell.empty() && std::all_of(cell.begin(), cell.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

SharedCommas shared_commas(std::string_view text, const CsvFormat& format) {
  if (format.delimiter != ',') return {};
  const std::size_t names = format.names.size();
  LineReader reader(text);
  CellSplitter splitter(',');
  SharedCommas first;
  std::string_view line;
  int number = 0;
  for (int seen = 0; seen < kRowsRead && reader.next(line, number);) {
    if (number < format.first_line || is_skipped_line(line)) continue;
    ++seen;
    splitter.split(line);
    const std::vector<std::string_view>& cells = splitter.cells();
    if (cells.size() > 2 * names || !std::all_of(cells.begin(), cells.end(), is_whole)) return {};
    if (first.line == 0 && cells.size() > names) first = {number, cells.size()};
  }
  return first;
}

}  // namespace lacuna
