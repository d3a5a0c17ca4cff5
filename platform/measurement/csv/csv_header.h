#pragma once

#include "measurement/csv/csv_format.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// A line of a file.
struct NumberedLine {
  std::string_view text;
  int number = 0;
};

/// The cells of a line, without quotes and surrounding spaces.
std::vector<std::string> cells_of(std::string_view line, char delimiter);

/// Whether a cell is a number with a decimal point or a decimal comma.
bool is_number_in_any_notation(std::string_view cell);

/// Which of the first lines of a file holds the column names: the one above the first rows of numbers and above their
/// units, of the same width; where that one does not name the time, the first that does. 0 where there is none.
/// `lines`: without blank lines and comments.
std::size_t header_among(const std::vector<NumberedLine>& lines, const CsvFormatHints& hints);

/// The units in a row below the header: no cell is a number, and most cells that are not empty are units; else nothing.
/// Cells that are not units, such as "°C", give an empty text.
std::vector<std::string> units_in_row(const std::vector<std::string>& cells);

}  // namespace lacuna
