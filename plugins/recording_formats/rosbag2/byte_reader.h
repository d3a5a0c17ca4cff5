#pragma once

#include "bad_bag.h"
#include "cdr_reader.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace lacuna::rosbag2 {

/// Reads little-endian numbers and texts from a record of an MCAP file. Throws `BadBag` beyond its end.
class ByteReader {
 public:
  ByteReader(Bytes bytes, const char* record) : rest_(bytes), record_(record) {}

  std::uint64_t number(std::size_t width) {
    const Bytes bytes = take(width);
    std::uint64_t value = 0;
    for (std::size_t i = width; i-- > 0;) value = value << 8 | bytes[i];
    return value;
  }
  /// A length of 4 bytes, then as many bytes.
  std::string text() {
    const Bytes bytes = take(number(4));
    return {bytes.begin(), bytes.end()};
  }
  /// So many bytes.
  Bytes take(std::uint64_t count) {
    if (count > rest_.size()) throw BadBag(std::string("has a ") + record_ + " record with a length beyond its end");
    const Bytes taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  Bytes rest() const { return rest_; }

 private:
  Bytes rest_;
  const char* record_;
};

}  // namespace lacuna::rosbag2
