#pragma once

#include "foundation/text/encoding.h"
#include "measurement/csv/read_table.h"

#include <optional>
#include <string>

namespace lacuna {

/// The column of time stamps of a file.
struct ClockColumn {
  std::string name;
  Encoding encoding;
  double seconds_per_unit = 1.0;
};

/// Continues time stamps that restart: at the encoding's number or, where none is stated, at a usual one for counters
/// and times of day, if the stamps came near it and restarted near its start.
void decode_clock(const ClockColumn& column, ReadTable& read);

/// A fraction of a second in a separate column.
struct FractionColumn {
  std::string name;
  double unit = 0.0;  ///< s
};

/// The column whose name belongs to that of a column of seconds: `nanosec` to `sec`, `stamp.nsecs` to `stamp.secs`,
/// `tv_usec` to `tv_sec`.
std::optional<FractionColumn> fraction_beside(const std::string& seconds, const std::vector<std::string>& names);

/// The period, in s, after which a clock that goes back from `before` to `after`, in s, may have restarted, although
/// this may be another trial as well: a second, a minute, an hour or half a day; 0: none. `usual`: interval of its
/// samples.
double period_of_step_back(double before, double after, double usual);

}  // namespace lacuna
