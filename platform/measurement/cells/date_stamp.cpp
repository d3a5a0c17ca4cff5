#include "measurement/cells/date_stamp.h"

#include <algorithm>
#include <charconv>
#include <chrono>

namespace lacuna {
namespace {

/// Takes parts from the front of a text; after a missing part, takes nothing more.
class Pieces {
 public:
  explicit Pieces(std::string_view text) : rest_(text) {}

  int digits(std::size_t count) {
    int value = 0;
    if (rest_.size() < count || rest_.substr(0, count).find_first_not_of(kDigits) != rest_.npos) good_ = false;
    if (!good_) return 0;
    std::from_chars(rest_.data(), rest_.data() + count, value);
    rest_.remove_prefix(count);
    return value;
  }
  /// One digit or two.
  int one_or_two() {
    const std::size_t count = rest_.size() > 1 && kDigits.find(rest_[1]) != kDigits.npos ? 2 : 1;
    return digits(count);
  }
  bool take(std::string_view any_of) {
    if (!good_ || rest_.empty() || any_of.find(rest_.front()) == any_of.npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void need(std::string_view any_of) { good_ = take(any_of); }
  char next() const { return rest_.empty() ? '\0' : rest_.front(); }

  /// What follows a decimal point.
  double fraction() {
    double value = 0.0, digit = 0.1;
    const std::size_t length = std::min(rest_.find_first_not_of(kDigits), rest_.size());
    good_ = good_ && length > 0;
    for (const char c : rest_.substr(0, length)) {
      value += digit * (c - '0');
      digit *= 0.1;
    }
    rest_.remove_prefix(length);
    return value;
  }
  bool all_read() const { return good_ && rest_.empty(); }

 private:
  static constexpr std::string_view kDigits = "0123456789";
  std::string_view rest_;
  bool good_ = true;
};

/// s east of UTC.
int zone(Pieces& pieces) {
  if (pieces.take("Zz") || pieces.next() == '\0') return 0;
  const int sign = pieces.next() == '-' ? -1 : 1;
  pieces.need("+-");
  const int hours = pieces.digits(2);
  pieces.take(":");
  const int minutes = pieces.next() == '\0' ? 0 : pieces.digits(2);
  return sign * (hours * 3600 + minutes * 60);
}

/// Hours to add for a twelve-hour clock; takes the AM or PM mark, if there is one.
std::optional<int> half_of_day(Pieces& pieces, int hour) {
  pieces.take(" ");
  const bool afternoon = pieces.take("Pp");
  if (!afternoon && !pieces.take("Aa")) return std::nullopt;
  pieces.need("Mm");
  return (afternoon ? 12 : 0) - (hour == 12 ? 12 : 0);
}

}  // namespace

std::optional<DateStamp> read_date_stamp(std::string_view text) {
  Pieces pieces(text);
  const int year = pieces.digits(4);
  pieces.need("-");
  const int month = pieces.digits(2);
  pieces.need("-");
  const int day = pieces.digits(2);
  pieces.need("Tt ");
  const int hour = pieces.digits(2);
  pieces.need(":");
  const int minute = pieces.digits(2);
  const int second = pieces.take(":") ? pieces.digits(2) : 0;
  DateStamp stamp;
  if (pieces.take(".,")) stamp.fraction = pieces.fraction();
  const int east = zone(pieces);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!pieces.all_read() || !date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  const int of_day = (hour * 60 + minute) * 60 + second;
  stamp.seconds = static_cast<std::int64_t>(days) * 86400 + of_day - east;
  return stamp;
}

std::optional<ClockTime> read_clock_time(std::string_view text) {
  Pieces pieces(text);
  int fields[3] = {pieces.one_or_two(), 0, 0};
  int count = 1;
  while (count < 3 && pieces.take(":")) fields[count++] = pieces.digits(2);
  if (count == 1) return std::nullopt;
  ClockTime time;
  if (pieces.take(count == 3 ? ".,:" : ".,"))
    time.since.fraction = pieces.fraction();
  else if (count == 2)
    return std::nullopt;  // hours with minutes
  const bool of_day = count == 3;
  const std::optional<int> half = of_day ? half_of_day(pieces, fields[0]) : std::nullopt;
  const int hour = of_day ? fields[0] : 0, minute = fields[count - 2], second = fields[count - 1];
  if (!pieces.all_read() || hour > (half ? 12 : 23) || minute > 59 || second > 60) return std::nullopt;
  time.since.seconds = ((hour + half.value_or(0)) * 60 + minute) * 60 + second;
  time.period = of_day ? 86400.0 : 3600.0;
  return time;
}

}  // namespace lacuna
