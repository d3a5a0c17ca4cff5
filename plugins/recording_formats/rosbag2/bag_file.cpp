#include "bag_file.h"

#include "bad_bag.h"
#include "topic_rows.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace lacuna::rosbag2 {
namespace {

constexpr std::size_t kLearnedMessages = 20;  ///< messages of each topic, which determine its columns
constexpr std::size_t kMostProblems = 100;
constexpr std::size_t kMostNamed = 8;

std::unique_ptr<Bag> open_bag(const std::string& path) {
  return path.ends_with(".db3") ? open_sqlite(path) : open_mcap(path);
}

/// Topics that ROS records about programs, not about robots.
bool is_of_programs(const std::string& topic) {
  constexpr std::array<std::string_view, 3> kOfPrograms = {"/rosout", "/parameter_events", "/events/write_split"};
  return std::find(kOfPrograms.begin(), kOfPrograms.end(), topic) != kOfPrograms.end();
}

std::string problem_with(const BagTopic& topic, std::size_t number, const BadBag& bad) {
  return "message " + std::to_string(number) + " of topic " + topic.name + " (" + topic.type + ") " + bad.what() +
         "; record it again, or leave this topic out";
}

/// Determines the columns of a bag's topics.
class ContentsReader {
 public:
  RecordingContents read(Bag& bag) {
    bag.visit([&](std::size_t topic) { return wants(bag, topic); },
              [&](const BagMessage& message) { return take(bag, message); });
    for (const auto& [index, columns] : columns_) {
      RecordedTable table = columns.table();
      if (!columns.refusal().empty())
        left_out_.emplace(bag.topics()[index].name + ": " + columns.refusal());
      else if (!table.columns.empty())
        contents_.tables.push_back(std::move(table));
    }
    tell_of_others(bag);
    return std::move(contents_);
  }

 private:
  bool wants(const Bag& bag, std::size_t topic) const {
    if (is_of_programs(bag.topics()[topic].name)) return false;
    const auto known = columns_.find(topic);
    return known == columns_.end() || (known->second.refusal().empty() && known->second.learned() < kLearnedMessages);
  }

  bool take(const Bag& bag, const BagMessage& message) {
    const BagTopic& topic = bag.topics()[message.topic];
    TopicColumns& columns = columns_.try_emplace(message.topic, topic).first->second;
    if (!columns.refusal().empty()) return !is_done(bag);
    try {
      columns.learn(message);
    } catch (const BadBag& bad) {
      contents_.problems.push_back({0, problem_with(topic, columns.learned(), bad)});
    }
    return contents_.problems.size() < kMostProblems && !is_done(bag);
  }

  /// Whether later messages cannot add columns.
  bool is_done(const Bag& bag) const {
    if (!bag.knows_topics()) return false;
    for (std::size_t t = 0; t < bag.topics().size(); ++t) {
      const BagTopic& topic = bag.topics()[t];
      if (is_of_programs(topic.name) || topic.messages == std::uint64_t{0}) continue;
      const auto known = columns_.find(t);
      if (known == columns_.end()) return false;
      const std::uint64_t enough = std::min<std::uint64_t>(kLearnedMessages, topic.messages.value_or(kLearnedMessages));
      if (known->second.refusal().empty() && known->second.learned() < enough) return false;
    }
    return true;
  }

  void tell_of_others(const Bag& bag) {
    std::string text;
    std::size_t named = 0;
    for (const std::string& one : left_out_)
      if (named++ < kMostNamed) text += (text.empty() ? "" : "; ") + one;
    if (named > kMostNamed) text += "; and " + std::to_string(named - kMostNamed) + " more";
    if (!text.empty()) contents_.remarks.push_back({0, "topics that are left out: " + text});
    for (const BagTopic& topic : bag.topics())
      if (topic.name.ends_with("robot_description"))
        contents_.remarks.push_back(
            {0, "topic " + topic.name +
                    " contains a robot description; save its text as a .urdf file to use it as the model"});
  }

  std::map<std::size_t, TopicColumns> columns_;
  std::set<std::string> left_out_;
  RecordingContents contents_;
};

/// Reads the rows of some topics.
class RowsReader {
 public:
  explicit RowsReader(const std::vector<TableQuery>& queries) : queries_(queries), rows_(queries.size()) {}

  ReadRows read(Bag& bag) {
    bag.visit([&](std::size_t topic) { return query_of(bag.topics()[topic].name) < queries_.size(); },
              [&](const BagMessage& message) { return take(bag, message); });
    for (std::size_t q = 0; q < queries_.size(); ++q) {
      if (!rows_[q]) {
        read_.tables.push_back(RowColumns(queries_[q]).take());
        continue;
      }
      tell_clock(queries_[q].table, rows_[q]->is_stamped());
      read_.tables.push_back(rows_[q]->take());
    }
    read_.doubts = bag.doubts();
    return std::move(read_);
  }

 private:
  bool take(const Bag& bag, const BagMessage& message) {
    const BagTopic& topic = bag.topics()[message.topic];
    const std::size_t query = query_of(topic.name);
    std::unique_ptr<TopicRows>& rows = rows_[query];
    if (!rows) rows = std::make_unique<TopicRows>(topic, queries_[query]);
    if (rows->is_full()) return !all_full();
    ++counts_[topic.name];
    try {
      if (rows->refusal().empty()) rows->add(message);
    } catch (const BadBag& bad) {
      read_.problems.push_back({0, problem_with(topic, counts_[topic.name], bad)});
    }
    return read_.problems.size() < kMostProblems;
  }

  std::size_t query_of(const std::string& topic) const {
    return static_cast<std::size_t>(
        std::find_if(queries_.begin(), queries_.end(), [&](const TableQuery& one) { return one.table == topic; }) -
        queries_.begin());
  }

  bool all_full() const {
    return std::all_of(rows_.begin(), rows_.end(), [](const auto& rows) { return rows && rows->is_full(); });
  }

  void tell_clock(const std::string& topic, bool is_stamped) {
    read_.remarks.push_back(
        {0, is_stamped ? "times of " + topic +
                             " are the stamps in its headers; to use the times of recording write time.column = \"" +
                             kReceived + "\""
                       : "times of " + topic + " are the times of recording, because its messages have no stamps"});
  }

  const std::vector<TableQuery>& queries_;
  std::vector<std::unique_ptr<TopicRows>> rows_;
  std::map<std::string, std::size_t> counts_;
  ReadRows read_;
};

}  // namespace

RecordingContents contents_of(const std::string& path) {
  try {
    return ContentsReader().read(*open_bag(path));
  } catch (const BadBag& bad) {
    RecordingContents contents;
    contents.problems.push_back({0, bad.what()});
    return contents;
  }
}

ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries) {
  try {
    return RowsReader(queries).read(*open_bag(path));
  } catch (const BadBag& bad) {
    ReadRows read;
    read.problems.push_back({0, bad.what()});
    return read;
  }
}

}  // namespace lacuna::rosbag2
