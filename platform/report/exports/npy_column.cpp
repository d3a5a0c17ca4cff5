#include "report/exports/npy_column.h"

#include "foundation/text/code_points.h"
#include "report/exports/little_endian.h"
#include "storage/queries/query_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace lacuna {
namespace {

constexpr std::string_view kNpyMagic{"\x93NUMPY\x01\x00", 8};
constexpr std::size_t kAlignment = 64;  ///< of the first number, bytes
constexpr std::int64_t kMostWholeReal = std::int64_t{1} << 53;
constexpr int kCharacter = 4;               ///< bytes
constexpr std::size_t kLongestNumber = 24;  ///< characters, "-1.7976931348623157e+308"

double real_of(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(&cell);
  return real ? *real : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void NpyColumn::see(const Cell& cell) {
  ++count_;
  if (std::holds_alternative<std::monostate>(cell)) {
    has_nothing_ = true;
  } else if (const auto* whole = std::get_if<std::int64_t>(&cell)) {
    has_whole_ = true;
    has_long_whole_ = has_long_whole_ || *whole > kMostWholeReal || *whole < -kMostWholeReal;
  } else if (std::holds_alternative<double>(cell)) {
    has_real_ = true;
  } else {
    has_text_ = true;
    longest_text_ = std::max(longest_text_, code_points(cell_text(cell)).size());
  }
}

NpyColumn::Type NpyColumn::type() const {
  if (has_text_) return Type::text;
  if (has_whole_ && !has_real_ && !has_nothing_) return Type::whole;
  return has_long_whole_ ? Type::text : Type::real;
}

std::size_t NpyColumn::longest() const {
  return std::max(longest_text_, has_whole_ || has_real_ ? kLongestNumber : std::size_t{1});
}

std::string NpyColumn::header() const {
  const std::string description = type() == Type::whole  ? "<i8"
                                  : type() == Type::real ? "<f8"
                                                         : fmt::format("<U{}", longest());
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}", description, count_);
  const std::size_t before = kNpyMagic.size() + 2 + text.size() + 1;
  text.append((kAlignment - before % kAlignment) % kAlignment, ' ');
  text += '\n';
  std::string header(kNpyMagic);
  append_number(header, text.size(), 2);
  return header + text;
}

std::string NpyColumn::bytes_of(const Cell& cell) const {
  std::string bytes;
  if (type() == Type::whole) {
    append_number(bytes, static_cast<std::uint64_t>(std::get<std::int64_t>(cell)), 8);
  } else if (type() == Type::real) {
    append_number(bytes, std::bit_cast<std::uint64_t>(real_of(cell)), 8);
  } else {
    for (const char32_t point : code_points(cell_text(cell))) append_number(bytes, point, kCharacter);
    bytes.resize(kCharacter * longest(), '\0');
  }
  return bytes;
}

}  // namespace lacuna
