#include "scalar_type.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace lacuna::numpy {
namespace {

constexpr std::size_t kLargestType = std::size_t{1} << 20;

/// "<f8": order, kind and a count of bytes or characters.
struct Parts {
  char order = '|', kind = ' ';
  std::size_t count = 0;
  std::string_view rest;
};

std::optional<Parts> parts_of(std::string_view description) {
  if (description.size() < 3 || std::string_view("<>=|").find(description[0]) == std::string_view::npos) return {};
  Parts parts;
  parts.order = description[0];
  parts.kind = description[1];
  const char* const end = description.data() + description.size();
  const auto [stopped, error] = std::from_chars(description.data() + 2, end, parts.count);
  if (error != std::errc() || parts.count > kLargestType) return {};
  parts.rest = {stopped, static_cast<std::size_t>(end - stopped)};
  return parts;
}

std::optional<std::int64_t> units_in_second(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, std::int64_t>, 4> kUnits = {
      {{"[s]", 1}, {"[ms]", 1'000}, {"[us]", 1'000'000}, {"[ns]", 1'000'000'000}}};
  for (const auto& [name, count] : kUnits)
    if (unit == name) return count;
  return {};
}

/// IEEE 754 binary16.
double half(std::uint16_t bits) {
  const int exponent = (bits >> 10) & 0x1f, fraction = bits & 0x3ff;
  const double size = exponent == 0x1f ? (fraction == 0 ? std::numeric_limits<double>::infinity()
                                                        : std::numeric_limits<double>::quiet_NaN())
                      : exponent == 0  ? std::ldexp(fraction, -24)
                                       : std::ldexp(fraction + 1024, exponent - 25);
  return (bits & 0x8000) != 0 ? -size : size;
}

double real_of(std::uint64_t bits, std::size_t size) {
  if (size == 8) return std::bit_cast<double>(bits);
  if (size == 4) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  return half(static_cast<std::uint16_t>(bits));
}

std::int64_t whole_of(std::uint64_t bits, std::size_t size) {
  const auto shift = static_cast<int>(64 - 8 * size);
  return static_cast<std::int64_t>(bits << shift) >> shift;
}

}  // namespace

std::optional<ScalarType> scalar_type(std::string_view description) {
  const auto parts = parts_of(description);
  if (!parts) return {};
  ScalarType type{ScalarType::Kind::real, parts->count, parts->order == '>'};
  const bool is_power = type.size == 1 || type.size == 2 || type.size == 4 || type.size == 8;
  if (!is_power) return {};
  if (parts->kind == 'M' || parts->kind == 'm') {
    const auto units = units_in_second(parts->rest);
    if (!units || type.size != 8) return {};
    type.kind = ScalarType::Kind::time;
    type.per_second = *units;
    return type;
  }
  if (!parts->rest.empty()) return {};
  switch (parts->kind) {
    case 'f': return type.size == 1 ? std::nullopt : std::optional(type);
    case 'i': type.kind = ScalarType::Kind::whole; return type;
    case 'u': type.kind = ScalarType::Kind::natural; return type;
    case 'b': type.kind = ScalarType::Kind::natural; return type.size == 1 ? std::optional(type) : std::nullopt;
    default: return {};
  }
}

std::optional<std::size_t> size_of_type(std::string_view description) {
  const auto parts = parts_of(description);
  if (!parts || parts->kind == 'O') return {};
  return parts->kind == 'U' ? 4 * parts->count : parts->count;
}

LongNumber read_scalar(const unsigned char* bytes, const ScalarType& type) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < type.size; ++i) bits = bits << 8 | bytes[type.is_big_endian ? i : type.size - 1 - i];
  switch (type.kind) {
    case ScalarType::Kind::real: return {0, real_of(bits, type.size)};
    case ScalarType::Kind::whole: return {whole_of(bits, type.size), 0.0};
    case ScalarType::Kind::natural:
      if (bits > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
        return {0, static_cast<double>(bits)};
      return {static_cast<std::int64_t>(bits), 0.0};
    case ScalarType::Kind::time: break;
  }
  const std::int64_t units = whole_of(bits, type.size);
  if (units == std::numeric_limits<std::int64_t>::min()) return {0, std::numeric_limits<double>::quiet_NaN()};
  return {units / type.per_second, static_cast<double>(units % type.per_second) / static_cast<double>(type.per_second)};
}

}  // namespace lacuna::numpy
