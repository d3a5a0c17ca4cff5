#include "measurement/guesses/robot_match.h"

#include "foundation/address.h"
#include "foundation/unit.h"
#include "measurement/names/column_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace lacuna {
namespace {

/// A sensor channel or an actuator without a column so far.
struct OpenChannel {
  Channel channel;
  ColumnRole role = ColumnRole::other;  ///< expected role of a column for it
  bool is_actuator = false;
  bool is_servo = false;
  std::vector<std::string> words;  ///< of its name and its element's
  std::optional<GuessedColumn> column;
};

enum class Dimension { unknown, same, other };

Dimension dimension_of(const GuessedColumn& column, const Channel& channel) {
  if (column.track) return channel.unit == "rad" ? Dimension::same : Dimension::other;
  const std::optional<Unit> unit = parse_unit(column.unit), wanted = parse_unit(channel.unit);
  if (column.unit.empty() || !unit || !wanted) return Dimension::unknown;
  return unit->same_dimension(*wanted) ? Dimension::same : Dimension::other;
}

ColumnRole role_of(SensorKind kind) {
  switch (kind) {
    case SensorKind::joint_position:
    case SensorKind::body_position:
    case SensorKind::link_angle:
    case SensorKind::beacon_range: return ColumnRole::position;
    case SensorKind::joint_velocity:
    case SensorKind::link_velocity:
    case SensorKind::body_velocity:
    case SensorKind::body_angular_velocity: return ColumnRole::velocity;
    case SensorKind::joint_force:
    case SensorKind::drive_force:
    case SensorKind::contact_force:
    case SensorKind::accelerometer:
    case SensorKind::touch:
    case SensorKind::body_orientation: return ColumnRole::other;
  }
  return ColumnRole::other;
}

bool is_servo(ActuatorKind kind) { return kind != ActuatorKind::force && kind != ActuatorKind::voltage; }

std::vector<OpenChannel> open_channels(const RobotSpec& robot) {
  const auto words = [](const std::string& name, const std::string& element) {
    std::vector<std::string> all = words_of(name), others = words_of(element);
    all.insert(all.end(), others.begin(), others.end());
    return all;
  };
  std::vector<OpenChannel> slots;
  for (const ActuatorSpec& actuator : robot.actuators)
    slots.push_back({command_channel(robot, actuator), ColumnRole::command, true, is_servo(actuator.kind),
                     words(actuator.name, actuator.joint), std::nullopt});
  for (const SensorSpec& sensor : robot.sensors)
    for (const Channel& channel : sensor_channels(robot, sensor))
      slots.push_back({channel, role_of(sensor.kind), false, false, words(channel.name, sensor.element), std::nullopt});
  return slots;
}

bool is_for_robot(const GuessedColumn& column) {
  return column.role != ColumnRole::time && column.role != ColumnRole::trial && !column.passed_over && !column.in_track;
}

bool fits(const OpenChannel& slot, const GuessedColumn& column) {
  const Dimension dimension = dimension_of(column, slot.channel);
  if (slot.is_actuator) {
    if (column.role == ColumnRole::command) return true;
    return slot.is_servo && column.role == ColumnRole::reference && dimension != Dimension::other;
  }
  if (column.role == ColumnRole::reference || column.role == ColumnRole::other) return false;
  if (dimension == Dimension::same) return slot.channel.unit != "1" || column.role == slot.role;
  return column.role == slot.role && (column.named_by_user || dimension == Dimension::unknown);
}

/// For a drive: whether the words of the column name its kind of command.
bool is_of_quantity(const OpenChannel& slot, const GuessedColumn& column) {
  if (!slot.is_actuator) return false;
  if (slot.is_servo) return column.role == ColumnRole::reference;
  return slot.channel.unit == "V" ? column.of_voltage : column.of_effort;
}

bool has_same_name(const OpenChannel& slot, const GuessedColumn& column) {
  const bool is_reading = column.role == ColumnRole::position || column.role == ColumnRole::velocity;
  const bool may_be =
      slot.is_actuator ? !is_reading : column.named_by_user || dimension_of(column, slot.channel) != Dimension::other;
  return may_be && (column.name == slot.channel.name || words_of(column.name) == words_of(slot.channel.name));
}

bool is_number(const std::string& word) { return number_in({word}).has_value(); }

bool has_word(const OpenChannel& slot, const std::string& word) {
  return std::ranges::find(slot.words, word) != slot.words.end();
}

/// Whether the word distinguishes the slot: another channel of its kind lacks the word, or there is no other. The word
/// "position" does not distinguish joints that all have a position.
bool tells_apart(const OpenChannel& slot, const std::string& word, const std::vector<OpenChannel>& slots) {
  const auto is_of_kind = [&](const OpenChannel& other) {
    return other.is_actuator == slot.is_actuator && other.channel.unit == slot.channel.unit;
  };
  return std::ranges::count_if(slots, is_of_kind) == 1 || std::ranges::any_of(slots, [&](const OpenChannel& other) {
           return is_of_kind(other) && !has_word(other, word);
         });
}

/// Number of words of the column's name that the channel or its element has, too; none where these are only numbers
/// (lists count from 0, joints mostly from 1), or only words that all channels of its kind have.
int shared_words(const OpenChannel& slot, const GuessedColumn& column, const std::vector<OpenChannel>& slots) {
  int shared = 0, numbers = 0;
  bool is_own = false;
  for (const std::string& word : words_of(column.name)) {
    if (!has_word(slot, word)) continue;
    ++shared;
    if (is_number(word)) ++numbers;
    is_own = is_own || (!is_number(word) && tells_apart(slot, word, slots));
  }
  return is_own || (numbers > 0 && numbers < shared) ? shared : 0;
}

/// Gives columns to slots; columns and slots that are taken are no longer candidates.
class Matching {
 public:
  Matching(std::vector<OpenChannel>& slots, const std::vector<GuessedColumn>& columns) : slots_(slots) {
    std::copy_if(columns.begin(), columns.end(), std::back_inserter(free_), is_for_robot);
  }

  /// Joints that count from 1 and columns that count from 0, or the reverse: q0 and q1 for joint1 and joint2. Equal
  /// names, q1 for q1, would cross them.
  void match_shifted_numbers() {
    for (const std::vector<std::size_t>& family : numbered_slots()) {
      std::map<int, std::size_t> slots;
      for (const std::size_t i : family) slots.emplace(*number_in(slots_[i].words), i);
      std::vector<std::map<int, std::string>> shifted;
      for (const auto& [stem, columns] : numbered_columns(slots_[family.front()]))
        if (const int shift = slots.begin()->first - columns.begin()->first;
            shift != 0 && columns.size() == slots.size() && has_numbers(columns, slots, shift))
          shifted.push_back(columns);
      if (shifted.size() != 1) continue;
      const int from = shifted.front().begin()->first;
      const std::string reason =
          fmt::format("its number, counted from {}; joints are counted from {}", from, slots.begin()->first);
      auto slot = slots.begin();
      for (const auto& [number, name] : shifted.front()) give((slot++)->second, name, reason);
    }
  }

  void match_same_names() {
    for (OpenChannel& slot : slots_)
      for (std::size_t i = 0; i < free_.size() && !slot.column; ++i)
        if (has_same_name(slot, free_[i])) give(slot, i, "it has the same name");
  }

  void match_shared_words() {
    while (match_best_words()) {
    }
  }

  /// Numbers that all occur among those of the slots identify them: q1 and q3 for joint1 to joint3.
  void match_numbers() {
    for (const bool of_actuators : {false, true})
      for (std::size_t first = 0; first < slots_.size(); ++first) {
        if (slots_[first].column || slots_[first].is_actuator != of_actuators) continue;
        const std::vector<std::size_t> columns = candidates(slots_[first]);
        std::map<int, std::size_t> by_number;
        for (std::size_t i = first; i < slots_.size(); ++i)
          if (!slots_[i].column && slots_[i].is_actuator == of_actuators && candidates(slots_[i]) == columns)
            if (const std::optional<int> number = number_in(slots_[i].words)) by_number.emplace(*number, i);
        std::map<int, std::string> named;
        for (const std::size_t i : columns)
          if (const std::optional<int> number = number_in(words_of(free_[i].name));
              number && by_number.contains(*number))
            named.emplace(*number, free_[i].name);
        if (named.size() != columns.size()) continue;
        for (const auto& [number, name] : named) {
          give(by_number.at(number), name, "its number");
        }
      }
  }

  void match_kinds() {
    for (std::size_t first = 0; first < slots_.size(); ++first) {
      if (slots_[first].column) continue;
      const std::vector<std::size_t> columns = candidates(slots_[first]);
      std::vector<std::size_t> peers;
      for (std::size_t i = 0; i < slots_.size(); ++i)
        if (!slots_[i].column && slots_[i].is_actuator == slots_[first].is_actuator && candidates(slots_[i]) == columns)
          peers.push_back(i);
      if (columns.empty() || peers.size() != columns.size()) continue;
      give_in_order(peers, columns);
    }
  }

  /// Those with the channel's unit if there are any, else those whose words name its quantity, else all possible ones.
  std::vector<std::size_t> candidates(const OpenChannel& slot) const {
    std::vector<std::size_t> fitting, of_quantity, of_unit;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (!fits(slot, free_[i])) continue;
      fitting.push_back(i);
      if (is_of_quantity(slot, free_[i])) of_quantity.push_back(i);
      if (dimension_of(free_[i], slot.channel) == Dimension::same) of_unit.push_back(i);
    }
    if (!of_unit.empty()) return of_unit;
    return of_quantity.empty() ? fitting : of_quantity;
  }

  const std::vector<GuessedColumn>& free() const { return free_; }

 private:
  using NumberedColumns = std::map<int, std::string>;

  static bool has_numbers(const NumberedColumns& columns, const std::map<int, std::size_t>& slots, int shift) {
    return std::ranges::all_of(columns, [&](const auto& one) { return slots.contains(one.first + shift); });
  }

  /// Open slots of one kind that all have different numbers.
  std::vector<std::vector<std::size_t>> numbered_slots() const {
    std::map<std::tuple<bool, ColumnRole, std::string>, std::vector<std::size_t>> kinds;
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (!slots_[i].column) kinds[{slots_[i].is_actuator, slots_[i].role, slots_[i].channel.unit}].push_back(i);
    std::vector<std::vector<std::size_t>> numbered;
    for (const auto& [kind, slots] : kinds) {
      std::set<int> numbers;
      for (const std::size_t i : slots)
        if (const std::optional<int> number = number_in(slots_[i].words)) numbers.insert(*number);
      if (slots.size() > 1 && numbers.size() == slots.size()) numbered.push_back(slots);
    }
    return numbered;
  }

  /// Possible columns for a slot, by their names without numbers.
  std::map<std::vector<std::string>, NumberedColumns> numbered_columns(const OpenChannel& slot) const {
    std::map<std::vector<std::string>, NumberedColumns> families;
    for (const std::size_t i : candidates(slot)) {
      std::vector<std::string> words = words_of(free_[i].name);
      const std::optional<int> number = number_in(words);
      if (!number || free_[i].named_by_user) continue;
      words.erase(std::prev(std::find_if(words.rbegin(), words.rend(), is_number).base()));
      families[words].emplace(*number, free_[i].name);
    }
    return families;
  }

  void give(std::size_t slot, const std::string& name, const std::string& reason) {
    const auto at = std::ranges::find(free_, name, &GuessedColumn::name);
    give(slots_[slot], static_cast<std::size_t>(at - free_.begin()), reason);
  }

  void give(OpenChannel& slot, std::size_t index, const std::string& reason) {
    slot.column = free_[index];
    if (!slot.column->named_by_user) slot.column->reason = reason;
    free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(index));
  }

  /// As many columns as slots; numbered columns are in the order of their numbers.
  void give_in_order(const std::vector<std::size_t>& peers, const std::vector<std::size_t>& columns) {
    std::vector<std::pair<int, GuessedColumn>> ordered;
    for (std::size_t i = 0; i < columns.size(); ++i) ordered.emplace_back(static_cast<int>(i), free_[columns[i]]);
    const auto number = [](const GuessedColumn& column) { return number_in(words_of(column.name)); };
    if (std::all_of(ordered.begin(), ordered.end(), [&](const auto& one) { return number(one.second).has_value(); }))
      for (auto& [place, column] : ordered) place = *number(column);
    std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::string reason = columns.size() == 1 ? "the only column that fits" : "the order of the columns";
    for (std::size_t i = 0; i < peers.size(); ++i) {
      const auto at = std::find_if(free_.begin(), free_.end(),
                                   [&](const GuessedColumn& one) { return one.name == ordered[i].second.name; });
      give(slots_[peers[i]], static_cast<std::size_t>(at - free_.begin()), reason);
    }
  }

  /// Matches one slot and one column that share more words with each other than either does with any other.
  bool match_best_words() {
    for (OpenChannel& slot : slots_)
      for (std::size_t i = 0; i < free_.size() && !slot.column; ++i) {
        const int shared = shared_words(slot, free_[i], slots_);
        if (shared == 0 || !fits(slot, free_[i]) || !is_best(slot, i, shared)) continue;
        give(slot, i, "its name");
        return true;
      }
    return false;
  }

  bool is_best(const OpenChannel& slot, std::size_t index, int shared) const {
    for (std::size_t i = 0; i < free_.size(); ++i)
      if (i != index && fits(slot, free_[i]) && shared_words(slot, free_[i], slots_) >= shared) return false;
    return std::none_of(slots_.begin(), slots_.end(), [&](const OpenChannel& other) {
      return &other != &slot && !other.column && fits(other, free_[index]) &&
             shared_words(other, free_[index], slots_) >= shared;
    });
  }

  std::vector<OpenChannel>& slots_;
  std::vector<GuessedColumn> free_;
};

}  // namespace

RobotMatch match_robot(const RobotSpec& robot, const std::vector<GuessedColumn>& columns) {
  std::vector<OpenChannel> slots = open_channels(robot);
  Matching matching(slots, columns);
  matching.match_shifted_numbers();
  matching.match_same_names();
  matching.match_shared_words();
  matching.match_numbers();
  matching.match_kinds();
  RobotMatch match;
  for (OpenChannel& slot : slots) {
    if (slot.column) {
      (slot.is_actuator ? match.commands : match.sensors).push_back({slot.channel, *slot.column});
      continue;
    }
    UnmatchedChannel left{slot.channel, slot.is_actuator, {}};
    for (const std::size_t i : matching.candidates(slot)) left.candidates.push_back(matching.free()[i].name);
    match.unmatched.push_back(std::move(left));
  }
  for (const GuessedColumn& column : matching.free()) {
    match.unused.push_back(column);
    if (column.role != ColumnRole::other)
      match.unused.back().reason = "all sensors and actuators of the robot already have a column";
  }
  for (const GuessedColumn& column : columns)
    if (column.passed_over) match.unused.push_back(column);
  return match;
}

}  // namespace lacuna
