#pragma once

#include "message_types.h"

#include <lacuna/value_tree.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace lacuna::rosbag2 {

using Bytes = std::span<const unsigned char>;

/// Reads messages in CDR, of both byte orders, plain (XCDR1) or plain of the second version (XCDR2), as used by DDS
/// (OMG DDS-XTypes 1.3, 7.4). Lists of more numbers than columns are allowed are skipped.
class CdrReader {
 public:
  /// Puts a message into the tree. Throws `BadBag` where the number of its bytes is not that of its type.
  void read(Bytes message, const MessageTypes& types, ValueTree& tree);

 private:
  void read_encapsulation();
  void read_message(std::size_t type, ValueTree* tree);
  void read_field(const MessageField& field, ValueTree* tree);
  void read_list(const MessageField& field, std::size_t count, ValueTree* tree);
  void read_once(const MessageField& field, std::string_view key, ValueTree* tree);
  std::string_view read_text();
  std::uint64_t read_bits(std::size_t size);
  std::uint32_t read_count();
  void align(std::size_t size);
  void need(std::uint64_t size) const;

  const MessageTypes* types_ = nullptr;
  Bytes bytes_;  ///< behind the encapsulation
  std::size_t place_ = 0, widest_ = 8;
  bool is_big_endian_ = false;
};

}  // namespace lacuna::rosbag2
