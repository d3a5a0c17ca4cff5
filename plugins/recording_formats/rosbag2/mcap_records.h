#pragma once

#include "bag.h"
#include "byte_reader.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lacuna::rosbag2 {

/// Records of an MCAP file by their opcodes (MCAP specification, version 0).
enum class McapOpcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  statistics = 0x0b,
  data_end = 0x0f
};

/// The topics of the channels and schemas found so far.
class McapTopics {
 public:
  void take_schema(Bytes record);
  void take_channel(Bytes record);
  /// Records the number of messages per channel.
  void take_statistics(Bytes record);

  const std::vector<BagTopic>& topics() const { return topics_; }
  bool has_counts() const { return has_counts_; }
  /// The topic of a channel. Throws `BadBag` for one that was not described.
  std::size_t topic_of(std::uint64_t channel) const;

 private:
  struct Schema {
    std::string name, encoding, text;
  };
  std::map<std::uint64_t, Schema> schemas_;
  std::map<std::uint64_t, std::size_t> channels_;  ///< indices of topics
  std::vector<BagTopic> topics_;
  bool has_counts_ = false;
};

}  // namespace lacuna::rosbag2
