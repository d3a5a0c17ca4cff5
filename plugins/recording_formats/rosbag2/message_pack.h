#pragma once

#include "cdr_reader.h"

#include <memory>
#include <string_view>
#include <vector>

namespace lacuna::rosbag2 {

/// Decompresses zstd or lz4 data (as a frame) into memory that is reused.
class MessagePack {
 public:
  static constexpr std::size_t kLargest = std::size_t{256} << 20;  ///< bytes, unpacked

  MessagePack();
  ~MessagePack();
  MessagePack(const MessagePack&) = delete;
  MessagePack& operator=(const MessagePack&) = delete;

  /// A message that was compressed separately, or uncompressed. Valid until the next call. Throws `BadBag`.
  Bytes unpack(Bytes message);
  /// All of a chunk; `compression`: "", "zstd" or "lz4".
  Bytes unpack(Bytes packed, std::string_view compression);

 private:
  struct Contexts;

  Bytes unpack_zstd(Bytes packed);
  Bytes unpack_lz4(Bytes packed);
  void grow();

  std::unique_ptr<Contexts> contexts_;
  std::vector<unsigned char> unpacked_;
};

}  // namespace lacuna::rosbag2
