#include "process/outside_trial.h"

#include "foundation/statistics.h"
#include "foundation/text/counted.h"
#include "process/json_message.h"
#include "process/quoted_text.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kRounding = 1e-9;  // relative, of times and limits
constexpr double kGaps = 1.5;       // of the samples' median interval: what may be missing at either end

double rounding_of(double bound) { return kRounding * std::max(1.0, std::abs(bound)); }

template <class Described>
std::vector<std::size_t> places_of(const std::vector<Channel>& channels, const std::vector<Described>& all) {
  std::vector<std::size_t> places;
  for (const Channel& channel : channels) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Described& one) { return one.name == channel.name; });
    places.push_back(static_cast<std::size_t>(found - all.begin()));
  }
  return places;
}

TimeSeries columns_of(const std::vector<Channel>& channels, const std::vector<std::size_t>& places,
                      const Eigen::VectorXd& times, const TimeSeries::Samples& values) {
  TimeSeries series{channels, times, TimeSeries::Samples(times.size(), static_cast<Eigen::Index>(channels.size()))};
  for (std::size_t c = 0; c < channels.size(); ++c)
    series.samples.col(static_cast<Eigen::Index>(c)) = values.col(static_cast<Eigen::Index>(places[c]));
  return series;
}

double median_interval(const Eigen::VectorXd& times) {
  std::vector<double> intervals;
  for (Eigen::Index i = 1; i < times.size(); ++i) intervals.push_back(times[i] - times[i - 1]);
  return median_of(intervals);
}

}  // namespace

ChannelOrder::ChannelOrder(const Hello& hello, const TestSpace& space)
    : hello_(hello),
      space_(space),
      sensors_(places_of(space.sensors, hello.sensors)),
      actuators_(places_of(space.actuators, hello.actuators)) {}

CommandSeries ChannelOrder::of_target(const CommandSeries& commands) const {
  const TimeSeries& series = commands.series;
  CommandSeries ordered{{{}, series.times, {}}, commands.hold};
  ordered.series.samples.setZero(series.times.size(), static_cast<Eigen::Index>(hello_.actuators.size()));
  for (std::size_t c = 0; c < series.channels.size(); ++c)
    for (std::size_t a = 0; a < space_.actuators.size(); ++a)
      if (space_.actuators[a].name == series.channels[c].name)
        ordered.series.samples.col(static_cast<Eigen::Index>(actuators_[a])) =
            series.samples.col(static_cast<Eigen::Index>(c));
  return ordered;
}

void ChannelOrder::commands_of_target(std::span<const double> commands, std::span<double> ordered) const {
  for (std::size_t a = 0; a < actuators_.size(); ++a) ordered[actuators_[a]] = commands[a];
}

void ChannelOrder::readings_of_model(std::span<const double> readings, std::span<double> ordered) const {
  for (std::size_t c = 0; c < sensors_.size(); ++c) ordered[c] = readings[sensors_[c]];
}

void ChannelOrder::check_readings(double time, std::span<const double> readings) const {
  for (const std::size_t place : sensors_) {
    const TargetSensor& sensor = hello_.sensors[place];
    const double reading = readings[place];
    const bool below = reading < sensor.lower - rounding_of(sensor.lower);
    const bool above = reading > sensor.upper + rounding_of(sensor.upper);
    if (!below && !above) continue;
    throw Error(fmt::format("sent {:.4g} {} for \"{}\" at {:.4g} s, outside the range of this sensor: its {} is {:.4g}",
                            reading / sensor.to_si, sensor.unit, sensor.name, time, below ? "least" : "most",
                            (below ? sensor.lower : sensor.upper) / sensor.to_si));
  }
}

TimeSeries ChannelOrder::measured(const Eigen::VectorXd& times, const TimeSeries::Samples& values) const {
  return columns_of(space_.sensors, sensors_, times, values);
}

TimeSeries ChannelOrder::applied(const Eigen::VectorXd& times, const TimeSeries::Samples& values) const {
  return columns_of(space_.actuators, actuators_, times, values);
}

std::vector<double> ChannelOrder::sensor_noise() const {
  std::vector<double> noise;
  for (const std::size_t place : sensors_) noise.push_back(hello_.sensors[place].noise);
  return noise;
}

void commands_at(const CommandSeries& commands, double time, std::span<double> values) {
  const Eigen::VectorXd& times = commands.series.times;
  const TimeSeries::Samples& samples = commands.series.samples;
  const double later = time + kRounding * std::max(1.0, std::abs(time));
  const auto after = std::upper_bound(times.begin(), times.end(), later) - times.begin();
  const Eigen::Index row = std::max<Eigen::Index>(after - 1, 0);
  const bool between = commands.hold == Hold::first_order && after > 0 && after < times.size();
  const double share = between ? std::clamp((time - times[row]) / (times[row + 1] - times[row]), 0.0, 1.0) : 0.0;
  for (std::size_t a = 0; a < values.size(); ++a) {
    const auto column = static_cast<Eigen::Index>(a);
    values[a] = samples(row, column);
    if (between) values[a] += share * (samples(row + 1, column) - samples(row, column));
  }
}

CommandSeries until(CommandSeries commands, double duration) {
  TimeSeries& series = commands.series;
  const auto within = std::upper_bound(series.times.begin(), series.times.end(), duration) - series.times.begin();
  if (within == series.times.size()) return commands;
  const bool on_its_way = commands.hold == Hold::first_order && within > 0 && series.times[within - 1] < duration;
  const Eigen::Index rows = std::max<Eigen::Index>(within + (on_its_way ? 1 : 0), 1);
  std::vector<double> last(static_cast<std::size_t>(series.samples.cols()));
  commands_at(commands, duration, last);
  series.times.conservativeResize(rows);
  series.samples.conservativeResize(rows, Eigen::NoChange);
  if (!on_its_way && within > 0) return commands;
  series.times[rows - 1] = duration;
  for (std::size_t a = 0; a < last.size(); ++a) series.samples(rows - 1, static_cast<Eigen::Index>(a)) = last[a];
  return commands;
}

void check_limits(const CommandSeries& commands, const Hello& hello) {
  for (std::size_t a = 0; a < hello.actuators.size(); ++a) {
    const TargetActuator& actuator = hello.actuators[a];
    const auto column = commands.series.samples.col(static_cast<Eigen::Index>(a));
    const double slack = kRounding * (actuator.upper - actuator.lower);
    if (column.allFinite() && column.minCoeff() >= actuator.lower - slack &&
        column.maxCoeff() <= actuator.upper + slack)
      continue;
    throw RefusedTest(fmt::format(
        "accepts {3:.4g} to {4:.4g} {5} for \"{0}\", but the test has {1:.4g} to {2:.4g}; nothing was sent to it",
        actuator.name, column.minCoeff() / actuator.to_si, column.maxCoeff() / actuator.to_si,
        actuator.lower / actuator.to_si, actuator.upper / actuator.to_si, actuator.unit));
  }
}

void check_extent(Samples& samples, const TestHeading& heading) {
  const double end = heading.duration * (1.0 + kRounding);
  Eigen::Index rows = samples.times.size();
  while (rows > 0 && samples.times[rows - 1] > end) --rows;
  samples.times.conservativeResize(rows);
  samples.values.conservativeResize(rows, Eigen::NoChange);
  if (rows < 2)
    throw Error(fmt::format("sent only {} of the test's {:.4g} s; at least two are needed",
                            counted(static_cast<std::size_t>(rows), "sample"), heading.duration));
  const double gap = std::max(kGaps * median_interval(samples.times), heading.period) * (1.0 + kRounding);
  const double first = samples.times[0], last = samples.times[rows - 1];
  if (first < -kRounding || first > gap || last < heading.duration - gap)
    throw Error(
        fmt::format("sent too few samples: they cover {:.4g} s to {:.4g} s, but the test lasts from 0 to {:.4g} s",
                    first, last, heading.duration));
}

void check_measured(const TimeSeries& measured) {
  for (std::size_t c = 0; c < measured.channels.size(); ++c)
    if (measured.samples.col(static_cast<Eigen::Index>(c)).array().isNaN().all())
      throw Error(fmt::format("sent no reading of \"{}\": null in every row", measured.channels[c].name));
}

std::vector<InitialValue> initial_values(const JointStarts& start, const std::vector<std::string>& coordinates) {
  std::vector<InitialValue> values;
  if (start.empty()) return values;
  for (const auto& [joint, known] : start)
    if (std::find(coordinates.begin(), coordinates.end(), joint) == coordinates.end())
      throw Error(fmt::format(
          "stated the initial state of {}, which is not a joint of the model with one coordinate; such joints are {}",
          quoted_text(joint), coordinates.empty() ? "none" : fmt::format("{}", fmt::join(coordinates, ", "))));
  for (const std::string& joint : coordinates) {
    const auto known = start.find(joint);
    values.push_back(known == start.end()
                         ? InitialValue{}
                         : InitialValue{InitialKnowledge::given, known->second.position, known->second.velocity});
  }
  return values;
}

void begin_at_start(TimeSeries& measured) {
  const double first = measured.times[0];
  if (first < -kRounding)
    throw Error(
        fmt::format("stated its initial state at 0 s, but its readings begin at {:.4g} s; begin the times with the "
                    "test, or leave out the initial state",
                    first));
  if (first <= kRounding) return;
  const Eigen::Index rows = measured.times.size();
  Eigen::VectorXd times(rows + 1);
  times << 0.0, measured.times;
  TimeSeries::Samples samples(rows + 1, measured.samples.cols());
  samples.row(0).setConstant(std::numeric_limits<double>::quiet_NaN());
  samples.bottomRows(rows) = measured.samples;
  measured.times = std::move(times);
  measured.samples = std::move(samples);
}

}  // namespace lacuna
