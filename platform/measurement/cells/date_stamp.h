#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace lacuna {

/// A moment, in seconds since 1970-01-01T00:00:00 UTC without leap seconds.
struct DateStamp {
  std::int64_t seconds = 0;
  double fraction = 0.0;  ///< s, 0 to 1, after `seconds`
};

/// Reads a date with a time of day in ISO 8601: `2024-05-01T12:00:00.25Z`; a space may replace the T, a comma the
/// point, and a zone such as `+02:00` or `+0200` the Z. Without a zone the time counts as UTC. Nothing where the text
/// is something else, or there is no such day or time of day.
std::optional<DateStamp> read_date_stamp(std::string_view text);

/// A time of day, or of an hour.
struct ClockTime {
  DateStamp since;      ///< the start of the day or hour
  double period = 0.0;  ///< s, after which the clock restarts
};

/// Reads a time of day such as `12:59:57.005`, `12:59:57,005`, `12:59:57:005` or `1:59:57.005 PM`, and minutes with
/// seconds such as `59:57.0`. Nothing where the text is something else, or there is no such time.
std::optional<ClockTime> read_clock_time(std::string_view text);

}  // namespace lacuna
