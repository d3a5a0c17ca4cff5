#pragma once

#include "cdr_reader.h"

#include <lacuna/recording_format.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lacuna::rosbag2 {

/// A topic of a bag and the type of its messages.
struct BagTopic {
  std::string name;
  std::string type;                            ///< "sensor_msgs/msg/JointState"
  std::string encoding;                        ///< of its messages: "cdr", "json"
  std::string definition;                      ///< of its type; empty: not in the bag
  std::string definition_encoding;             ///< "ros2msg", "ros2idl"
  std::optional<std::uint64_t> messages = {};  ///< number of messages, if the bag states it
};

struct BagMessage {
  std::size_t topic = 0;      ///< index
  std::int64_t received = 0;  ///< ns since 1970, when it was recorded
  Bytes bytes;                ///< valid during the visit
};

/// A bag of messages in a file. Throws `BadBag` for data that cannot be read.
class Bag {
 public:
  virtual ~Bag() = default;

  /// Those found so far; all of them from the beginning where `knows_topics`.
  virtual const std::vector<BagTopic>& topics() const = 0;
  virtual bool knows_topics() const = 0;
  /// Visits the messages of the topics that `wants`, by index, in the order of the file until `visit` returns false.
  virtual void visit(const std::function<bool(std::size_t)>& wants,
                     const std::function<bool(const BagMessage&)>& visit) = 0;
  /// The parts that a whole visit left out.
  virtual std::vector<RecordingSentence> doubts() const { return {}; }
};

std::unique_ptr<Bag> open_mcap(const std::string& path);
std::unique_ptr<Bag> open_sqlite(const std::string& path);

}  // namespace lacuna::rosbag2
