#pragma once

#include "measurement/csv/csv_format.h"

#include <string_view>

namespace lacuna {

/// Whether the last line of a file, which no line end ends, breaks off in its last number: that has fewer digits than
/// each number above it in the same column, of the last hundred lines. Whole lines without a line end look otherwise.
bool ends_in_cut_number(std::string_view text, const CsvFormat& format);

}  // namespace lacuna
