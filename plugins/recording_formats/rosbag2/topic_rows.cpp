#include "topic_rows.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace lacuna::rosbag2 {
namespace {

constexpr std::string_view kLayout = "layout.data_offset";  ///< of arrays of std_msgs; without information on a robot
constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

LongNumber seconds_of(std::int64_t nanoseconds) {
  return {nanoseconds / kNanosecondsPerSecond,
          static_cast<double>(nanoseconds % kNanosecondsPerSecond) / static_cast<double>(kNanosecondsPerSecond)};
}

/// Packages whose numbers are in SI units (REP 103).
bool is_in_si(const std::string& type) {
  constexpr std::array<std::string_view, 5> kPackages = {"sensor_msgs/", "geometry_msgs/", "nav_msgs/",
                                                         "trajectory_msgs/", "control_msgs/"};
  return std::any_of(kPackages.begin(), kPackages.end(),
                     [&](std::string_view package) { return type.starts_with(package); });
}

struct UnitOfPath {
  std::string_view part, unit;
};

/// Units by the names in a message. After them come x, y, z, or the path ends.
std::string_view unit_of(std::string_view path) {
  constexpr std::array<UnitOfPath, 7> kUnits = {{{"angular_velocity.", "rad/s"},
                                                 {"linear_acceleration.", "m/s^2"},
                                                 {"force.", "N"},
                                                 {"torque.", "N*m"},
                                                 {"twist.linear.", "m/s"},
                                                 {"twist.angular.", "rad/s"},
                                                 {"pose.position.", "m"}}};
  for (const auto& [part, unit] : kUnits)
    if (const std::size_t place = path.find(part); place != path.npos && place + part.size() + 1 == path.size())
      return unit;
  return kSomeSiUnit;
}

}  // namespace

TopicColumns::TopicColumns(const BagTopic& topic) : name_(topic.name), is_si_(is_in_si(topic.type)), decoder_(topic) {}

void TopicColumns::learn(const BagMessage& message) {
  ++learned_;
  decoder_.decode(message.bytes, tree_);
  paths_.walk(
      tree_,
      [&](std::string_view path, LongNumber) {
        if (path != kStamp && path != kLayout && !path.empty())
          columns_.add(path, is_si_ ? unit_of(path) : std::string_view());
      },
      [](std::string_view, std::size_t) {});
}

RecordedTable TopicColumns::table() const {
  RecordedTable table{name_, {}, kTime};
  if (columns_.size() == 0) return table;
  table.columns = {{kTime, "s"}, {kReceived, "s"}};
  for (RecordedColumn& column : columns_.columns())
    if (column.name != kTime && column.name != kReceived) table.columns.push_back(std::move(column));
  return table;
}

TopicRows::TopicRows(const BagTopic& topic, const TableQuery& query)
    : decoder_(topic),
      rows_(query),
      time_(static_cast<std::size_t>(std::find(query.columns.begin(), query.columns.end(), kTime) -
                                     query.columns.begin())) {}

void TopicRows::add(const BagMessage& message) {
  decoder_.decode(message.bytes, tree_);
  LongNumber stamp;
  rows_.begin_row();
  rows_.put(kReceived, seconds_of(message.received));
  const auto put = [&](std::string_view path, LongNumber number) {
    if (path == kStamp)
      stamp = number;
    else if (path != kTime)
      rows_.put(path, number);
  };
  paths_.walk(tree_, put, [](std::string_view, std::size_t) {});
  if (!is_begun_) is_stamped_ = stamp.whole != 0 || stamp.part != 0.0;
  is_begun_ = true;
  rows_.put(kTime, is_stamped_ ? stamp : seconds_of(message.received));
}

/// Messages of several publishers are not recorded in the order of their stamps.
RecordedRows TopicRows::take() {
  RecordedRows rows = rows_.take();
  if (time_ >= rows.columns.size()) return rows;
  const std::vector<double> times = rows.columns[time_];
  if (std::is_sorted(times.begin(), times.end())) return rows;
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  for (std::vector<double>& column : rows.columns) {
    const std::vector<double> before = column;
    for (std::size_t i = 0; i < order.size(); ++i) column[i] = before[order[i]];
  }
  return rows;
}

}  // namespace lacuna::rosbag2
