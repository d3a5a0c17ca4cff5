#pragma once

#include "bag.h"

#include <lacuna/json_tree.h>

namespace lacuna::rosbag2 {

/// Converts the messages of a topic into trees.
class TopicDecoder {
 public:
  explicit TopicDecoder(const BagTopic& topic);

  /// Why its messages cannot be read, half a sentence; empty: they can.
  const std::string& refusal() const { return refusal_; }
  /// Throws `BadBag`: "has 12 bytes where its type has 20".
  void decode(Bytes message, ValueTree& tree);

 private:
  void decode_cdr(Bytes message, ValueTree& tree);

  std::string refusal_;
  bool is_json_ = false;
  std::vector<MessageTypes> versions_;  ///< of its type; the first message decides
  bool knows_version_ = false;
  CdrReader cdr_;
  JsonTree json_;
};

}  // namespace lacuna::rosbag2
