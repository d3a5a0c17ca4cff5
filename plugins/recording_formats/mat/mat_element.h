#pragma once

#include <lacuna/value_tree.h>

#include <byte_stream.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace lacuna::mat {

using namespace recording_bytes;

/// Types of data elements (MAT-File Format, version 5, table 1-1).
enum class MatType : std::uint32_t {
  int8 = 1,
  uint8 = 2,
  int16 = 3,
  uint16 = 4,
  int32 = 5,
  uint32 = 6,
  real32 = 7,
  real64 = 9,
  int64 = 12,
  uint64 = 13,
  matrix = 14,
  compressed = 15
};

/// The beginning of a data element.
struct MatTag {
  MatType type{};
  std::uint64_t size = 0;  ///< bytes of its data
  bool is_small = false;   ///< the data are in the tag
  std::array<unsigned char, 4> small = {};
};

/// Reads data elements from a stream within the length of the enclosing element. Throws `BadFile` where a length
/// exceeds it.
class MatReader {
 public:
  /// `size`: number of bytes of the stream.
  MatReader(ByteStream& stream, bool is_big_endian, std::uint64_t size)
      : stream_(stream), is_big_endian_(is_big_endian), left_(size) {}

  std::uint64_t left() const { return left_; }
  MatTag read_tag();
  /// All data of an element of at most `most` bytes; skips padding.
  std::vector<unsigned char> read_data(const MatTag& tag, std::size_t most);
  void skip_data(const MatTag& tag);
  void skip_all() { skip(left_); }
  /// A reader of an element's content, which must be read or skipped to its end; then call `leave`.
  MatReader within(const MatTag& tag) { return {stream_, is_big_endian_, tag.size}; }
  void leave(const MatTag& tag) {
    left_ -= tag.size;
    skip_padding(tag);
  }
  /// Its numbers one after another; `number(index, value)`.
  void read_numbers(const MatTag& tag, const std::function<void(std::uint64_t, LongNumber)>& number);
  /// Number of numbers in an element; 0 for a type without numbers.
  static std::uint64_t count_of(const MatTag& tag);

  /// A whole number of an element's data.
  std::uint64_t number_at(const std::vector<unsigned char>& data, std::size_t place) const;

 private:
  void take(unsigned char* into, std::size_t count);
  void skip(std::uint64_t count);
  void skip_padding(const MatTag& tag);
  LongNumber number_of(const unsigned char* bytes, MatType type) const;

  ByteStream& stream_;
  bool is_big_endian_;
  std::uint64_t left_;
};

}  // namespace lacuna::mat
