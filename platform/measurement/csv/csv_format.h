#pragma once

#include "measurement/csv/file_report.h"

#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// The format of a CSV file, and the place of its first sample.
struct CsvFormat {
  char delimiter = ',';  ///< ' ': runs of spaces and tabs
  bool decimal_comma = false;
  std::vector<std::string> names;  ///< of the columns, without quotes and surrounding spaces
  std::vector<std::string> units;  ///< from a row of units under the header, as written without brackets; else empty
  int header_line = 0;
  int first_line = 0;  ///< first line that may be a sample
};

/// Settings of the experiment for the format.
struct CsvFormatHints {
  /// Identifies the header among the lines above it; empty: the first line with text is the header.
  std::string time_column;
  char delimiter = '\0';  ///< '\0': found out
  bool decimal_comma = false;
};

/// Detects the format of `text`: `sep=;` lines, comments (# or %), lines above the header, a header in the last
/// comment, the delimiter (; tab comma | spaces), a row of units, decimal commas. Reports what cannot be read and what
/// was not obvious; without a header the result has no names.
CsvFormat find_csv_format(std::string_view text, const CsvFormatHints& hints, FileReport& report);

/// Whether a line is skipped: blank, or a comment.
bool is_skipped_line(std::string_view line);

}  // namespace lacuna
