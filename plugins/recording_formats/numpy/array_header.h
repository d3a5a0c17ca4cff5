#pragma once

#include "byte_stream.h"
#include "scalar_type.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::numpy {

using namespace recording_bytes;

/// A number in an element of an array: the whole element, or a field of a structured type.
struct Field {
  std::string path;  ///< "position[2]"; empty: the element itself
  std::size_t offset = 0;
  ScalarType type;
};

/// The header of an .npy file (NEP 1, versions 1 to 3).
struct ArrayHeader {
  std::vector<Field> fields;
  std::vector<std::string> left_out;  ///< paths of fields that are not numbers
  std::size_t element_size = 0;       ///< bytes
  bool is_fortran_order = false;
  std::vector<std::uint64_t> shape;

  std::uint64_t rows() const { return shape.empty() ? 0 : shape.front(); }
  /// Number of elements per row; 0 where there are more than columns are allowed.
  std::size_t row_elements() const;
};

/// The largest number of numbers in a row of one array.
inline constexpr std::size_t kMostNumbers = 4096;

/// Reads the header and leaves the stream at the first element. Throws `BadFile`.
ArrayHeader read_header(ByteStream& stream);

/// The same for the header's text, a Python dictionary.
ArrayHeader parse_header(std::string_view text);

}  // namespace lacuna::numpy
