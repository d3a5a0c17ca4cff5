#include "topic_decoder.h"

#include "bad_bag.h"

#include <utility>

namespace lacuna::rosbag2 {

TopicDecoder::TopicDecoder(const BagTopic& topic) {
  is_json_ = topic.encoding == "json";
  if (is_json_) return;
  if (topic.encoding != "cdr") {
    refusal_ =
        "its messages are in the encoding \"" + topic.encoding.substr(0, 40) + "\"; only cdr and json can be read";
    return;
  }
  try {
    if (topic.definition.empty())
      versions_ = known_types(topic.type);
    else if (topic.definition_encoding == "ros2msg")
      versions_ = {parse_definition(topic.type, topic.definition)};
    else
      refusal_ = "its type is defined as \"" + topic.definition_encoding.substr(0, 40) + "\"; only ros2msg can be read";
  } catch (const BadBag& bad) {
    refusal_ = bad.what();
  }
  knows_version_ = versions_.size() == 1;
}

void TopicDecoder::decode(Bytes message, ValueTree& tree) {
  if (!is_json_) return decode_cdr(message, tree);
  const std::string fault = json_.read({reinterpret_cast<const char*>(message.data()), message.size()}, tree);
  if (!fault.empty()) throw BadBag("is not JSON: " + fault);
}

/// The version of the type whose messages have this number of bytes.
void TopicDecoder::decode_cdr(Bytes message, ValueTree& tree) {
  while (!knows_version_ && versions_.size() > 1) {
    try {
      cdr_.read(message, versions_.front(), tree);
      knows_version_ = true;
      return;
    } catch (const BadBag&) {
      versions_.erase(versions_.begin());
    }
  }
  cdr_.read(message, versions_.front(), tree);
}

}  // namespace lacuna::rosbag2
