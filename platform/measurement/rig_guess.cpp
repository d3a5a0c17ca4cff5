#include "measurement/rig_guess.h"

#include "foundation/address.h"
#include "foundation/text/problem.h"
#include "foundation/unit.h"
#include "measurement/clocks/clock_check.h"
#include "measurement/names/column_words.h"
#include "measurement/csv/file_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

using Columns = std::vector<GuessedColumn>;
using Slot = std::optional<GuessedColumn> GuessedJoint::*;

bool same_dimension(const std::string& a, std::string_view b) {
  const std::optional<Unit> first = parse_unit(a), second = parse_unit(b);
  return first && second && first->same_dimension(*second);
}

Columns with_role(const Columns& columns, ColumnRole role) {
  Columns found;
  std::copy_if(columns.begin(), columns.end(), std::back_inserter(found),
               [role](const GuessedColumn& column) { return column.role == role; });
  return found;
}

std::string reason_for_no_place(const GuessedColumn& column) {
  if (column.role != ColumnRole::command) return "all joints already have a column";
  return "all joints already have a drive; if it drives one, name it with --command";
}

/// Gives each column to the joint with its name, to the only joint, or in order where there are as many columns as
/// joints. Columns without a joint are unused.
void attach(RigGuess& guess, const Columns& columns, Slot slot) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    GuessedJoint* place = nullptr;
    for (GuessedJoint& joint : guess.joints) {
      const GuessedColumn& known = joint.position ? *joint.position : *joint.velocity;
      if (known.joint == columns[i].joint && !(joint.*slot)) place = &joint;
    }
    const bool in_order = guess.joints.size() == columns.size() || guess.joints.size() == 1;
    if (!place && in_order) place = &guess.joints[std::min(i, guess.joints.size() - 1)];
    if (place && !(place->*slot)) {
      place->*slot = columns[i];
    } else {
      guess.unused.push_back(columns[i]);
      guess.unused.back().reason = reason_for_no_place(columns[i]);
    }
  }
}

/// The share of samples in which a column is active.
double activity(const FileSample& sample, const GuessedColumn& column) {
  const std::vector<double>& values = sample.columns[static_cast<std::size_t>(sample.find(column.name))];
  return static_cast<double>(std::count_if(values.begin(), values.end(), [](double value) { return value != 0.0; }));
}

bool slides(const GuessedJoint& joint) {
  if (joint.position && joint.position->track) return false;
  for (const auto& [column, unit] :
       {std::pair(&joint.position, "m"), std::pair(&joint.velocity, "m/s"), std::pair(&joint.command, "N")})
    if (*column && same_dimension((*column)->unit, unit)) return true;
  return false;
}

void make_joints(RigGuess& guess, const Columns& columns) {
  const Columns positions = with_role(columns, ColumnRole::position);
  const Columns velocities = with_role(columns, ColumnRole::velocity);
  for (const GuessedColumn& column : positions.empty() ? velocities : positions) {
    GuessedJoint joint;
    (positions.empty() ? joint.velocity : joint.position) = column;
    guess.joints.push_back(joint);
  }
  if (guess.joints.empty()) return;
  if (!positions.empty()) attach(guess, velocities, &GuessedJoint::velocity);
}

/// Torques and forces come first among commands, then the most active, so that a disturbance that is mostly zero is not
/// used as the drive, nor a current or a voltage where the torque is known.
Columns commands_by_activity(const Columns& columns, const FileSample& sample, std::size_t joints) {
  Columns commands = with_role(columns, ColumnRole::command);
  std::map<std::string, double> active;
  double most = 0.0;
  for (const GuessedColumn& command : commands) {
    active[command.name] = activity(sample, command);
    most = std::max(most, active[command.name]);
  }
  const auto is_effort = [&](const GuessedColumn& one) { return one.of_effort && 2.0 * active[one.name] >= most; };
  std::stable_sort(commands.begin(), commands.end(), [&](const GuessedColumn& a, const GuessedColumn& b) {
    if (is_effort(a) != is_effort(b)) return is_effort(a);
    return joints == 1 && active[a.name] > active[b.name];
  });
  return commands;
}

/// The joint of a setpoint: of several with its name, one without a drive so far.
GuessedJoint* joint_of(RigGuess& guess, const GuessedColumn& reference) {
  GuessedJoint* found = nullptr;
  for (GuessedJoint& joint : guess.joints)
    if (guess.joints.size() == 1 || (joint.position && joint.position->joint == reference.joint))
      if (!found || (found->command && !joint.command)) found = &joint;
  return found;
}

ActuatorKind servo_for(const GuessedColumn& reference) {
  const bool of_velocity = reference.unit.empty()
                               ? reference.of_velocity
                               : same_dimension(reference.unit, "m/s") || same_dimension(reference.unit, "rad/s");
  return of_velocity ? ActuatorKind::velocity_servo : ActuatorKind::position_servo;
}

void attach_drives(RigGuess& guess, const Columns& columns, const FileSample& sample) {
  attach(guess, commands_by_activity(columns, sample, guess.joints.size()), &GuessedJoint::command);
  for (GuessedJoint& joint : guess.joints)
    if (joint.command && joint.command->of_voltage) joint.actuator = ActuatorKind::voltage;
  for (const GuessedColumn& reference : with_role(columns, ColumnRole::reference)) {
    GuessedJoint* joint = joint_of(guess, reference);
    if (joint && !joint->command) {
      joint->command = reference;
      joint->actuator = servo_for(reference);
      continue;
    }
    guess.unused.push_back(reference);
    if (joint) guess.unused.back().reason += fmt::format("; `{}` drives the joint", joint->command->name);
  }
}

void name_joints(RigGuess& guess) {
  for (std::size_t i = 0; i < guess.joints.size(); ++i) {
    GuessedJoint& joint = guess.joints[i];
    joint.slides = slides(joint);
    joint.only_one = guess.joints.size() == 1;
    const std::string& key = joint.position ? joint.position->joint : joint.velocity->joint;
    const bool is_word = !key.empty() && std::isalpha(static_cast<unsigned char>(key.front()));
    if (joint.only_one)
      joint.name = joint.slides ? "slider" : "hinge";
    else
      joint.name = is_word ? key : "joint" + (key.empty() ? std::to_string(i + 1) : key);
    const auto same = std::count_if(guess.joints.begin(), guess.joints.begin() + static_cast<std::ptrdiff_t>(i),
                                    [&](const GuessedJoint& other) { return other.name == joint.name; });
    if (same > 0) joint.name += "_" + std::to_string(i + 1);
  }
}

/// A time without a unit: sampling intervals of robots are about milliseconds.
void settle_time_unit(RigGuess& guess, const FileSample& sample) {
  guess.time_unit_reason = "its name";
  if (same_dimension(guess.time.unit, "s")) return;
  const double interval = median_interval(sample.columns[static_cast<std::size_t>(sample.find(guess.time.name))]);
  guess.time.unit = interval < 0.5 ? "s" : interval < 200.0 ? "ms" : interval < 2e5 ? "us" : "ns";
  guess.time_unit_reason = fmt::format("samples are {:.3g} apart", interval);
}

void settle_hold(RigGuess& guess) {
  guess.hold_reason = "a controller holds its output between samples";
  for (const MatchedColumn& command : guess.commands)
    if (tell_measured(words_of(command.column.name))) {
      guess.hold = Hold::first_order;
      guess.hold_reason = fmt::format("`{}` is measured, not held", command.column.name);
    }
}

/// Columns of the first file that all others have, too.
Columns common_columns(const std::vector<FileSample>& samples, const ColumnHints& hints) {
  Columns columns = guess_columns(samples.front(), hints);
  for (const FileSample& sample : samples)
    for (GuessedColumn& column : columns) {
      if (sample.find(column.name) >= 0) continue;
      if (column.role == ColumnRole::time)
        throw_problem(
            {sample.path.string(), sample.first_place(), 0},
            fmt::format("no column `{}`, which is the time in {}; recordings of one rig must have the same columns",
                        column.name, samples.front().label()));
      column.role = ColumnRole::other;
      column.reason = fmt::format("{} does not have it", sample.label());
    }
  return columns;
}

bool has_no_rows(const FileSample& sample) {
  return std::all_of(sample.columns.begin(), sample.columns.end(), [](const auto& column) { return column.empty(); });
}

/// Time and trials.
RigGuess guess_clock(const Columns& columns, const FileSample& first) {
  RigGuess guess;
  const Columns times = with_role(columns, ColumnRole::time);
  if (has_no_rows(first)) throw_problem({first.path.string(), first.first_place(), 0}, "has a header but no samples");
  if (times.empty())
    throw_problem(
        {first.path.string(), first.first_place(), 0},
        "no column increases as time does; name it with --time. The columns are " + listed(first.format.names));
  guess.time = times.front();
  settle_time_unit(guess, first);
  const Columns trials = with_role(columns, ColumnRole::trial);
  if (!trials.empty()) guess.trial = trials.front();
  return guess;
}

/// The sensors and the motors of the draft of the robot, with the columns of their joints.
void match_joints(RigGuess& guess) {
  for (const GuessedJoint& joint : guess.joints) {
    if (joint.position) guess.sensors.push_back({{joint.position_sensor(), position_unit(joint)}, *joint.position});
    if (joint.velocity) guess.sensors.push_back({{joint.velocity_sensor(), velocity_unit(joint)}, *joint.velocity});
    if (joint.command) guess.commands.push_back({{joint.motor(), command_unit(joint)}, *joint.command});
  }
}

/// A column assumed to be SI has the unit of its role.
void settle_units(RigGuess& guess) {
  const auto settle = [](GuessedColumn& column, const std::string& unit) {
    if (column.in_si && column.unit.empty()) column.unit = unit;
  };
  for (auto* matches : {&guess.sensors, &guess.commands})
    for (MatchedColumn& match : *matches) settle(match.column, match.channel.unit);
  for (GuessedJoint& joint : guess.joints) {
    if (joint.position) settle(*joint.position, position_unit(joint));
    if (joint.velocity) settle(*joint.velocity, velocity_unit(joint));
    if (joint.command) settle(*joint.command, command_unit(joint));
  }
}

/// "angle in rad, velocity in rad/s".
std::string sensors_in_words(const RobotSpec& robot) {
  std::string text;
  for (const Channel& channel : sensor_channels(robot))
    text += (text.empty() ? "" : ", ") + channel.name + " in " + channel.unit;
  return text.empty() ? "it has none" : text;
}

}  // namespace

std::string GuessedJoint::body() const { return only_one ? (slides ? "carriage" : "arm") : name + "_link"; }
std::string GuessedJoint::motor() const { return only_one ? "motor" : name + "_motor"; }
std::string GuessedJoint::position_sensor() const {
  const std::string what = slides ? "position" : "angle";
  return only_one ? what : name + "_" + what;
}
std::string GuessedJoint::velocity_sensor() const { return only_one ? "velocity" : name + "_velocity"; }

RigGuess guess_rig(const std::vector<FileSample>& samples, const ColumnHints& hints) {
  const FileSample& first = samples.front();
  const Columns columns = common_columns(samples, hints);
  RigGuess guess = guess_clock(columns, first);
  make_joints(guess, columns);
  if (guess.joints.empty())
    throw_problem({first.path.string(), first.first_place(), 0},
                  "no column looks like a position or velocity; name one with --position or --velocity. The columns "
                  "are " +
                      listed(first.format.names));
  attach_drives(guess, columns, first);
  name_joints(guess);
  match_joints(guess);
  settle_hold(guess);
  settle_units(guess);
  for (const GuessedColumn& column : with_role(columns, ColumnRole::other))
    if (!column.in_track) guess.unused.push_back(column);
  return guess;
}

RigGuess guess_rig(const std::vector<FileSample>& samples, const ColumnHints& hints, const RobotSpec& robot) {
  const FileSample& first = samples.front();
  const Columns columns = common_columns(samples, hints);
  RigGuess guess = guess_clock(columns, first);
  RobotMatch match = match_robot(robot, columns);
  if (match.sensors.empty())
    throw_problem({first.path.string(), first.first_place(), 0},
                  fmt::format("no column fits a sensor of the robot ({}); name one with --position or --velocity. The "
                              "columns are {}",
                              sensors_in_words(robot), listed(first.format.names)));
  guess.sensors = std::move(match.sensors);
  guess.commands = std::move(match.commands);
  guess.unmatched = std::move(match.unmatched);
  guess.unused = std::move(match.unused);
  settle_hold(guess);
  settle_units(guess);
  return guess;
}

std::string position_unit(const GuessedJoint& joint) { return joint.slides ? "m" : "rad"; }
std::string velocity_unit(const GuessedJoint& joint) { return joint.slides ? "m/s" : "rad/s"; }

std::string command_unit(const GuessedJoint& joint) {
  if (joint.actuator == ActuatorKind::position_servo) return position_unit(joint);
  if (joint.actuator == ActuatorKind::velocity_servo) return velocity_unit(joint);
  if (joint.actuator == ActuatorKind::voltage) return "V";
  return joint.slides ? "N" : "N*m";
}

RecordingSource source_of(const RigGuess& guess, const std::vector<GuessedFile>& files) {
  RecordingSource source;
  for (const GuessedFile& file : files) source.files.push_back({.path = file.path, .table = file.run});
  source.time_column = guess.time.name;
  source.time_unit = guess.time.unit;
  if (guess.trial) source.trial_column = guess.trial->name;
  const auto mapping = [](const MatchedColumn& match) {
    const auto& [channel, column] = match;
    ColumnMapping result;
    result.channel = channel.name;
    result.column = column.name;
    result.unit = column.unit.empty() ? channel.unit : column.unit;
    if (column.track) {
      result.track = {column.track->other, {column.track->pivot_x, column.track->pivot_y}, kHangingDown};
      return result;
    }
    if (!same_dimension(result.unit, channel.unit))
      result.gain_unit = fmt::format("{}/({})", channel.unit, result.unit);
    return result;
  };
  for (const MatchedColumn& match : guess.sensors) source.sensors.push_back(mapping(match));
  for (const MatchedColumn& match : guess.commands) source.commands.push_back(mapping(match));
  return source;
}

}  // namespace lacuna
