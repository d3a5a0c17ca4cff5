#include "mcap_records.h"

#include <algorithm>
#include <utility>

namespace lacuna::rosbag2 {
namespace {

constexpr std::size_t kMostTopics = 65536;

}  // namespace

void McapTopics::take_schema(Bytes record) {
  ByteReader reader(record, "schema");
  const std::uint64_t id = reader.number(2);
  if (id == 0) throw BadBag("has a schema with the number 0, which is not allowed");
  Schema schema;
  schema.name = reader.text();
  schema.encoding = reader.text();
  schema.text = reader.text();
  schemas_.insert_or_assign(id, std::move(schema));
}

void McapTopics::take_channel(Bytes record) {
  ByteReader reader(record, "channel");
  const std::uint64_t id = reader.number(2), schema_id = reader.number(2);
  BagTopic topic;
  topic.name = reader.text();
  topic.encoding = reader.text();
  if (channels_.contains(id)) return;
  const auto schema = schemas_.find(schema_id);
  if (schema == schemas_.end() && schema_id != 0)
    throw BadBag("has a channel, of topic " + topic.name.substr(0, 60) +
                 ", with a schema that is not defined before it");
  if (schema != schemas_.end()) {
    topic.type = schema->second.name;
    topic.definition = schema->second.text;
    topic.definition_encoding = schema->second.encoding;
  }
  const auto known =
      std::find_if(topics_.begin(), topics_.end(), [&](const BagTopic& one) { return one.name == topic.name; });
  channels_.emplace(id, static_cast<std::size_t>(known - topics_.begin()));
  if (known != topics_.end() && (known->type != topic.type || known->encoding != topic.encoding))
    throw BadBag("has messages of the types " + known->type + " and " + topic.type + " in topic " + topic.name);
  if (known != topics_.end()) return;
  if (topics_.size() == kMostTopics) throw BadBag("has more than 65536 topics");
  topics_.push_back(std::move(topic));
}

void McapTopics::take_statistics(Bytes record) {
  ByteReader reader(record, "statistics");
  reader.take(8 + 2 + 4 + 4 + 4 + 4 + 8 + 8);  // counts and times of the whole file
  ByteReader counts(reader.take(reader.number(4)), "statistics");
  for (BagTopic& topic : topics_) topic.messages = 0;
  while (!counts.rest().empty()) {
    const auto channel = channels_.find(counts.number(2));
    const std::uint64_t count = counts.number(8);
    if (channel == channels_.end()) return;
    std::uint64_t& messages = *topics_[channel->second].messages;
    if (__builtin_add_overflow(messages, count, &messages)) return;
  }
  has_counts_ = true;
}

std::size_t McapTopics::topic_of(std::uint64_t channel) const {
  const auto found = channels_.find(channel);
  if (found == channels_.end())
    throw BadBag("has a message of channel " + std::to_string(channel) + ", which is not defined before it");
  return found->second;
}

}  // namespace lacuna::rosbag2
