#pragma once

#include "measurement/csv/csv_format.h"

#include <string_view>

namespace lacuna {

/// Whether the last line of a file without a line end is cut within its last number: that number has fewer digits than
/// each number above it in the same column, of the last hundred lines. Complete lines without a line end do not show
/// this.
bool ends_in_cut_number(std::string_view text, const CsvFormat& format);

}  // namespace lacuna
