#pragma once

#include "topic_decoder.h"

#include <lacuna/row_columns.h>

#include <string>

namespace lacuna::rosbag2 {

/// The columns of every topic: its time, s, from the stamps in its messages' headers where they have one, and the time
/// of recording, s since 1970.
inline constexpr const char* kTime = "t";
inline constexpr const char* kReceived = "log_time";
/// The place of a stamp in a message.
inline constexpr const char* kStamp = "header.stamp";

/// Determines the columns of a topic from some of its messages.
class TopicColumns {
 public:
  explicit TopicColumns(const BagTopic& topic);

  const std::string& refusal() const { return decoder_.refusal(); }
  /// Throws `BadBag` for a message that does not match its type.
  void learn(const BagMessage& message);
  std::size_t learned() const { return learned_; }
  /// Empty where its messages have no numbers.
  RecordedTable table() const;

 private:
  std::string name_;
  bool is_si_;
  TopicDecoder decoder_;
  ValueTree tree_;
  NumberPaths paths_;
  ColumnNames columns_;
  std::size_t learned_ = 0;
};

/// Collects the rows of a topic.
class TopicRows {
 public:
  TopicRows(const BagTopic& topic, const TableQuery& query);

  const std::string& refusal() const { return decoder_.refusal(); }
  bool is_full() const { return rows_.is_full(); }
  bool is_stamped() const { return is_stamped_; }
  void add(const BagMessage& message);
  /// In the order of time.
  RecordedRows take();

 private:
  TopicDecoder decoder_;
  ValueTree tree_;
  NumberPaths paths_;
  RowColumns rows_;
  std::size_t time_;  ///< index of the column `kTime` in the query
  bool is_begun_ = false, is_stamped_ = false;
};

}  // namespace lacuna::rosbag2
