#pragma once

#include "measurement/csv/csv_format.h"

#include <string_view>

namespace lacuna {

/// A row in which commas may be decimal signs and delimiters at once, as in `0,01,0,5` under two names.
struct SharedCommas {
  int line = 0;           ///< 0: there is none
  std::size_t cells = 0;  ///< in that line
};

/// The first such row among the first sixty. Only in a comma-separated file where all of these rows consist of whole
/// numbers, none has more than two cells per name, and at least one has more cells than names.
SharedCommas shared_commas(std::string_view text, const CsvFormat& format);

}  // namespace lacuna
