#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace lacuna {

/// The content of a cell of a measured file.
enum class CellKind {
  number,
  missing,   ///< empty, NaN, NA, null, none, "-": nothing was measured
  infinite,  ///< inf, or a number outside the range of a double
  text
};

struct NumberCell {
  CellKind kind = CellKind::text;
  double value = 0.0;  ///< NaN unless it is a number
};

std::string_view trimmed(std::string_view text);

/// Reads a cell; spaces around it do not count. With `decimal_comma`, `0,5` is one half and `0.5` text.
NumberCell read_number(std::string_view cell, bool decimal_comma);

/// Reads time stamps without loss where they count from a distant origin (seconds or nanoseconds since 1970), or are
/// dates or times of day (date_stamp.h): whole units are subtracted from each stamp as integers before it becomes a
/// double. All stamps of a file are of the kind of the first.
class TimeStampReader {
 public:
  explicit TimeStampReader(bool decimal_comma) : decimal_comma_(decimal_comma) {}

  /// The stamp minus `origin()`, which the first stamp determines: 0 unless it is beyond 10^6. For a date or a time of
  /// day in s.
  NumberCell read(std::string_view cell);
  double origin() const { return static_cast<double>(origin_); }
  /// Whether the stamps are dates or times of day, which need no unit.
  bool dated() const { return dated_; }
  /// s, period of times of day or of an hour; 0: none.
  double period() const { return period_; }

 private:
  struct Dated;
  static std::optional<Dated> dated_stamp(std::string_view cell);
  NumberCell read_dated(const Dated& stamp);

  bool decimal_comma_;
  bool has_origin_ = false, dated_ = false;
  std::int64_t origin_ = 0;
  double period_ = 0.0;
};

}  // namespace lacuna
