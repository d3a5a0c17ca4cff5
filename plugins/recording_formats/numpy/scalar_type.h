#pragma once

#include <lacuna/value_tree.h>

#include <cstddef>
#include <optional>
#include <string_view>

namespace lacuna::numpy {

/// The representation of a number in memory.
struct ScalarType {
  enum class Kind { real, whole, natural, time };
  Kind kind = Kind::real;
  std::size_t size = 0;  ///< bytes
  bool is_big_endian = false;
  std::int64_t per_second = 1;  ///< for a time: units per second
};

/// The type of a description such as "<f8", ">i2", "|b1" or "<M8[ns]"; none: not a number that can be read.
std::optional<ScalarType> scalar_type(std::string_view description);

/// The size of any description with a fixed size, such as "<U8" or "|S3", bytes; none: it has none, or is unknown.
std::optional<std::size_t> size_of_type(std::string_view description);

/// The number at a position; an undefined time (NaT) is NaN.
LongNumber read_scalar(const unsigned char* bytes, const ScalarType& type);

}  // namespace lacuna::numpy
