#include "measurement/cells/number_cell.h"

#include "measurement/cells/date_stamp.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kLongestNumber = 64;

bool same_word(std::string_view a, std::string_view lower) {
  return std::equal(a.begin(), a.end(), lower.begin(), lower.end(),
                    [](char x, char y) { return (x >= 'A' && x <= 'Z' ? x + ('a' - 'A') : x) == y; });
}

bool stands_for_missing(std::string_view cell) {
  static constexpr std::string_view kWords[] = {"",     "nan",  "-nan", "+nan", "na",       "n/a",
                                                "null", "none", "-",    "--",   "nan(ind)", "-nan(ind)"};
  return std::any_of(std::begin(kWords), std::end(kWords),
                     [&](std::string_view word) { return same_word(cell, word); });
}

bool stands_for_infinity(std::string_view cell) {
  if (!cell.empty() && (cell.front() == '-' || cell.front() == '+')) cell.remove_prefix(1);
  return same_word(cell, "inf") || same_word(cell, "infinity") || same_word(cell, "1.#inf");
}

NumberCell read_word(std::string_view cell) {
  if (stands_for_missing(cell)) return {CellKind::missing, kNoNumber};
  return {stands_for_infinity(cell) ? CellKind::infinite : CellKind::text, kNoNumber};
}

NumberCell read_with_point(std::string_view cell) {
  const bool plus = cell.starts_with('+') && !cell.starts_with("+-");
  const std::string_view unsigned_cell = plus ? cell.substr(1) : cell;
  double value = kNoNumber;
  const auto [end, error] = std::from_chars(unsigned_cell.data(), unsigned_cell.data() + unsigned_cell.size(), value);
  const bool whole = end == unsigned_cell.data() + unsigned_cell.size();
  if (!whole || error == std::errc::invalid_argument) return read_word(cell);
  if (error == std::errc::result_out_of_range) {
    const bool underflow = cell.find("e-") != cell.npos || cell.find("E-") != cell.npos;
    return underflow ? NumberCell{CellKind::number, std::numeric_limits<double>::denorm_min()}
                     : NumberCell{CellKind::infinite, kNoNumber};
  }
  return std::isfinite(value) ? NumberCell{CellKind::number, value} : read_word(cell);
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

NumberCell read_number(std::string_view cell, bool decimal_comma) {
  cell = trimmed(cell);
  if (!decimal_comma || cell.find_first_of(",.") == cell.npos) return read_with_point(cell);
  if (cell.size() > kLongestNumber || cell.find('.') != cell.npos) return {CellKind::text, kNoNumber};
  std::array<char, kLongestNumber> with_point;
  std::replace_copy(cell.begin(), cell.end(), with_point.begin(), ',', '.');
  return read_with_point({with_point.data(), cell.size()});
}

struct TimeStampReader::Dated {
  DateStamp since;
  double period = 0.0;
};

std::optional<TimeStampReader::Dated> TimeStampReader::dated_stamp(std::string_view cell) {
  if (const std::optional<DateStamp> date = read_date_stamp(cell)) return Dated{*date};
  if (const std::optional<ClockTime> time = read_clock_time(cell)) return Dated{time->since, time->period};
  return std::nullopt;
}

NumberCell TimeStampReader::read(std::string_view cell) {
  constexpr std::int64_t kFarAway = 1'000'000;
  cell = trimmed(cell);
  const std::optional<Dated> dated = has_origin_ && !dated_ ? std::nullopt : dated_stamp(cell);
  if (dated && (!has_origin_ || dated->period == period_)) return read_dated(*dated);
  if (dated_) return stands_for_missing(cell) ? read_word(cell) : NumberCell{CellKind::text, kNoNumber};
  std::int64_t whole = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), whole);
  const std::string_view rest = cell.substr(static_cast<std::size_t>(end - cell.data()));
  const bool plain = error == std::errc() && (rest.empty() || (rest.front() == (decimal_comma_ ? ',' : '.') &&
                                                               rest.find_first_not_of("0123456789", 1) == rest.npos));
  if (plain && !has_origin_) origin_ = std::abs(whole) > kFarAway ? whole : 0;
  has_origin_ = true;
  if (origin_ == 0) return read_number(cell, decimal_comma_);
  if (!plain) {
    NumberCell number = read_number(cell, decimal_comma_);
    number.value -= origin();
    return number;
  }
  const double fraction = rest.size() > 1 ? read_number(rest, decimal_comma_).value : 0.0;
  return {CellKind::number, static_cast<double>(whole - origin_) + (cell.front() == '-' ? -fraction : fraction)};
}

NumberCell TimeStampReader::read_dated(const Dated& stamp) {
  if (!dated_) origin_ = stamp.since.seconds;
  dated_ = has_origin_ = true;
  period_ = stamp.period;
  return {CellKind::number, static_cast<double>(stamp.since.seconds - origin_) + stamp.since.fraction};
}

}  // namespace lacuna
