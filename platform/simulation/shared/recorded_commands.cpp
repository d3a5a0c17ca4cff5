#include "simulation/shared/recorded_commands.h"

#include "foundation/text/problem.h"
#include "simulation/shared/joint_tree.h"

#include <algorithm>
#include <cmath>

namespace lacuna::simulation {
namespace {

constexpr std::ptrdiff_t kUnset = -2;

void check_series(const CommandSeries& commands, const RobotSpec& robot) {
  const TimeSeries& series = commands.series;
  const auto channels = static_cast<Eigen::Index>(series.channels.size());
  if (series.samples.rows() != series.times.size() || series.samples.cols() != channels)
    throw Error("the command series has " + std::to_string(series.times.size()) + " times and " +
                std::to_string(channels) + " channels, but its samples are " + std::to_string(series.samples.rows()) +
                " x " + std::to_string(series.samples.cols()));
  if (channels > 0 && series.times.size() == 0) throw Error("the command series has channels but no samples");
  // The reader of a series checks every stamp; here only faults that would break a search are checked.
  if (channels > 0 &&
      !(std::abs(series.times[0]) < kInfinity && series.times[0] <= series.times[series.times.size() - 1]))
    throw Error("the command series' times must ascend from a finite start");
  if (!commands.before.empty() && commands.before.size() != series.channels.size())
    throw Error("the command series gives initial commands for " + std::to_string(commands.before.size()) + " of its " +
                std::to_string(channels) + " channels");
  std::vector<std::string> actuators;
  for (const ActuatorSpec& actuator : robot.actuators) actuators.push_back(actuator.name);
  for (const Channel& channel : series.channels)
    if (index_of(robot.actuators, channel.name) < 0)
      throw Error("the command channel \"" + channel.name + "\" does not have the name of an actuator of the robot" +
                  did_you_mean(channel.name, actuators));
}

}  // namespace

void RecordedCommands::open(const CommandSeries& commands, const RobotSpec& robot) {
  check_series(commands, robot);
  commands_ = &commands;
  columns_.clear();
  for (const ActuatorSpec& actuator : robot.actuators)
    columns_.push_back(index_of(commands.series.channels, actuator.name));
  cursors_.assign(columns_.size(), kUnset);
}

double RecordedCommands::at(std::size_t actuator, double time) {
  if (columns_[actuator] < 0) return 0.0;
  return value_in(find_segment(actuator, time), columns_[actuator], time);
}

double RecordedCommands::mean(std::size_t actuator, double from, double to) {
  const int column = columns_[actuator];
  if (column < 0) return 0.0;
  std::ptrdiff_t segment = find_segment(actuator, from);
  if (end_of(segment) >= to) return mean_in(segment, column, from, to);
  double integral = 0.0;
  for (double begin = from; begin < to; ++segment) {
    const double end = std::min(to, end_of(segment));
    if (end > begin) integral += (end - begin) * mean_in(segment, column, begin, end);
    begin = end;
  }
  return integral / (to - from);
}

std::ptrdiff_t RecordedCommands::find_segment(std::size_t actuator, double time) {
  const Eigen::VectorXd& times = commands_->series.times;
  std::ptrdiff_t& cursor = cursors_[actuator];
  if (cursor == kUnset || (cursor >= 0 && time < times[cursor]))
    cursor = std::upper_bound(times.data(), times.data() + times.size(), time) - times.data() - 1;
  while (time >= end_of(cursor)) ++cursor;
  return cursor;
}

double RecordedCommands::end_of(std::ptrdiff_t segment) const {
  const Eigen::VectorXd& times = commands_->series.times;
  if (segment + 1 >= times.size()) return kInfinity;
  return times[segment + 1];
}

double RecordedCommands::value_in(std::ptrdiff_t segment, int column, double time) const {
  const TimeSeries& series = commands_->series;
  if (segment < 0) return commands_->before_first(column);
  const double value = series.samples(segment, column);
  if (commands_->hold == Hold::zero_order || segment + 1 >= series.times.size()) return value;
  const double share = (time - series.times[segment]) / (series.times[segment + 1] - series.times[segment]);
  return value + share * (series.samples(segment + 1, column) - value);
}

double RecordedCommands::mean_in(std::ptrdiff_t segment, int column, double from, double to) const {
  return value_in(segment, column, 0.5 * (from + to));  // exact: a segment is constant or linear
}

}  // namespace lacuna::simulation
