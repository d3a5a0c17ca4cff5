#include "process/conversation.h"

#include "foundation/text/counted.h"
#include "process/json_message.h"
#include "process/trial_messages.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

namespace lacuna {
namespace {

constexpr double kJitter = 0.5;  // of a control period: how far readings may be off its beginning

bool is_at_rest(const StartState& start) {
  const auto is_zero = [](double value) { return value == 0.0; };
  return std::all_of(start.positions.begin(), start.positions.end(), is_zero) &&
         std::all_of(start.velocities.begin(), start.velocities.end(), is_zero);
}

}  // namespace

std::size_t whole_periods(double duration, double period) {
  return static_cast<std::size_t>(std::floor(duration / period + 1e-9));
}

Conversation::Conversation(ChildLines& lines, const Hello& hello, const TestSpace& space, const TestHeading& heading,
                           ChildLines::Clock::time_point until)
    : lines_(lines),
      hello_(hello),
      space_(space),
      heading_(heading),
      until_(until),
      order_(hello, space),
      clipped_(hello.actuators.size(), 0) {}

Trial Conversation::carry_out(const Test& test) {
  if (!is_at_rest(test.start))
    throw RefusedTest(
        "starts from its present state, but the test has another initial state; leave the initial state out of the "
        "test");
  if (const auto* series = std::get_if<CommandSeries>(&test.drive)) {
    const CommandSeries ordered = until(order_.of_target(*series), heading_.duration);
    check_limits(ordered, hello_);
    if (hello_.takes_series) return whole(ordered);
    return period_by_period(
        [&](const Readings&, double due, std::span<double> commands) { commands_at(ordered, due, commands); });
  }
  if (!hello_.exchanges)
    throw RefusedTest(
        "takes only whole command series, but the test is a controller; set test.encoding = \"command_series\"");
  const Controller& controller = *std::get<std::shared_ptr<const Controller>>(test.drive);
  std::vector<double> state(static_cast<std::size_t>(controller.state_size()), 0.0);
  std::vector<double> seen(space_.sensors.size()), wanted(space_.actuators.size());
  return period_by_period([&](const Readings& now, double, std::span<double> commands) {
    order_.readings_of_model(now.sensors, seen);
    for (std::size_t c = 0; c < seen.size(); ++c)
      if (std::isnan(seen[c]))
        throw Error(
            fmt::format("sent null for \"{}\", which the controller of the test reads", space_.sensors[c].name));
    controller.act(now.time, seen, state, wanted);
    order_.commands_of_target(wanted, commands);
  });
}

Trial Conversation::whole(const CommandSeries& commands) {
  lines_.send(series_message(heading_, hello_, commands), until_);
  Samples samples = read_samples(lines_.receive(until_), hello_, heading_.id);
  check_extent(samples, heading_);
  for (Eigen::Index row = 0; row < samples.times.size(); ++row)
    order_.check_readings(samples.times[row],
                          {samples.values.row(row).data(), static_cast<std::size_t>(samples.values.cols())});
  start_ = samples.start;
  Trial trial;
  trial.commands = {order_.applied(commands.series.times, commands.series.samples), commands.hold};
  trial.measured = order_.measured(samples.times, samples.values);
  check_measured(trial.measured);
  trial.sensor_noise = order_.sensor_noise();
  return trial;
}

/// Readings at the beginning of each period, commands for it, and readings at its end.
template <class Drive>
Trial Conversation::period_by_period(Drive&& drive) {
  const auto periods = static_cast<Eigen::Index>(heading_.periods);
  Eigen::VectorXd times(periods + 1);
  TimeSeries::Samples values(periods + 1, static_cast<Eigen::Index>(hello_.sensors.size()));
  TimeSeries::Samples applied(periods, static_cast<Eigen::Index>(hello_.actuators.size()));
  std::vector<double> commands(hello_.actuators.size());
  lines_.send(exchange_message(heading_), until_);
  for (Eigen::Index k = 0; k <= periods; ++k) {
    const Readings readings =
        next_readings(static_cast<std::size_t>(k), k > 0 ? times[k - 1] : -std::numeric_limits<double>::infinity());
    order_.check_readings(readings.time, readings.sensors);
    if (k == 0) start_ = readings.start;
    times[k] = readings.time;
    for (std::size_t c = 0; c < readings.sensors.size(); ++c)
      values(k, static_cast<Eigen::Index>(c)) = readings.sensors[c];
    if (k == periods) break;
    drive(readings, static_cast<double>(k) * heading_.period, std::span<double>(commands));
    clip(commands);
    for (std::size_t a = 0; a < commands.size(); ++a) applied(k, static_cast<Eigen::Index>(a)) = commands[a];
    lines_.send(commands_message(hello_, commands), until_);
  }
  Trial trial;
  trial.commands = {order_.applied(times.head(periods), applied), Hold::zero_order};
  trial.measured = order_.measured(times, values);
  check_measured(trial.measured);
  trial.sensor_noise = order_.sensor_noise();
  return trial;
}

Readings Conversation::next_readings(std::size_t period, double before) {
  Readings readings = read_readings(lines_.receive(until_), hello_, heading_.id);
  const double due = static_cast<double>(period) * heading_.period;
  if (readings.time > before && std::abs(readings.time - due) <= kJitter * heading_.period) return readings;
  throw Error(
      fmt::format("is out of step: readings {} of the test are due at {:.4g} s, but it sent those of {:.4g} s; if it "
                  "cannot keep a control period of {:.4g} s, lengthen engine.control_period",
                  period, due, readings.time, heading_.period));
}

void Conversation::clip(std::vector<double>& commands) {
  for (std::size_t a = 0; a < commands.size(); ++a) {
    const TargetActuator& actuator = hello_.actuators[a];
    if (!std::isfinite(commands[a]))
      throw Error(
          fmt::format("was not sent a command of \"{}\", because it is not a number; this is a fault of the controller",
                      actuator.name));
    const double within = std::clamp(commands[a], actuator.lower, actuator.upper);
    if (within != commands[a]) ++clipped_[a];
    commands[a] = within;
  }
}

std::vector<std::string> Conversation::notes() const {
  std::vector<std::string> notes;
  for (std::size_t a = 0; a < clipped_.size(); ++a)
    if (clipped_[a] > 0)
      notes.push_back(fmt::format("{} of \"{}\" {} beyond the target's limits and were clipped to them",
                                  counted(clipped_[a], "command"), hello_.actuators[a].name,
                                  clipped_[a] == 1 ? "was" : "were"));
  return notes;
}

}  // namespace lacuna
