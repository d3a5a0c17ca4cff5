#include "measurement/csv/cut_number.h"

#include "measurement/csv/csv_lines.h"
#include "measurement/cells/number_cell.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>

namespace lacuna {
namespace {

constexpr int kLinesAbove = 100;
constexpr int kFewestDecimals = 5;  ///< numbers above, each with digits after its decimal sign
constexpr int kFewestIntegers =
    20;  ///< numbers above without, because a number may have one digit fewer than the one before

struct WrittenLength {
  std::ptrdiff_t behind_sign = 0;  ///< characters, including those of an exponent
  std::ptrdiff_t digits = 0;
};

/// Of the last cell of a line, if that is a number and the line has all cells.
std::optional<WrittenLength> length_of_last(std::string_view line, const CsvFormat& format) {
  CellSplitter splitter(format.delimiter);
  if (is_skipped_line(line) || splitter.split(line) != CellSplitter::Result::split) return std::nullopt;
  if (splitter.cells().size() != format.names.size()) return std::nullopt;
  const std::string_view cell = trimmed(splitter.cells().back());
  if (read_number(cell, format.decimal_comma).kind != CellKind::number) return std::nullopt;
  const std::size_t sign = cell.find(format.decimal_comma ? ',' : '.');
  const auto digits =
      std::count_if(cell.begin(), cell.end(), [](char c) { return std::isdigit(static_cast<unsigned char>(c)); });
  return WrittenLength{sign == cell.npos ? 0 : static_cast<std::ptrdiff_t>(cell.size() - sign - 1), digits};
}

}  // namespace

bool ends_in_cut_number(std::string_view text, const CsvFormat& format) {
  const std::size_t last = text.rfind('\n');
  if (last == text.npos || last + 1 == text.size()) return false;
  const std::optional<WrittenLength> cut = length_of_last(text.substr(last + 1), format);
  std::string_view above = text.substr(0, last);
  int decimals = 0, integers = 0;
  for (int line = 0; line < kLinesAbove && cut && !above.empty(); ++line) {
    const std::size_t end = above.rfind('\n');
    if (const auto length = length_of_last(above.substr(end == above.npos ? 0 : end + 1), format)) {
      (length->behind_sign > 0 ? decimals : integers) += 1;
      const bool as_long = length->behind_sign > 0 ? length->behind_sign <= cut->behind_sign
                                                   : cut->behind_sign > 0 || length->digits <= cut->digits;
      if (as_long || (decimals > 0 && integers > 0)) return false;
    }
    above = above.substr(0, end == above.npos ? 0 : end);
  }
  return decimals >= kFewestDecimals || integers >= kFewestIntegers;
}

}  // namespace lacuna
