#include "process/trial_messages.h"

#include "foundation/text/counted.h"
#include "process/json_message.h"
#include "process/quoted_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

using Json = nlohmann::json;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

Json heading_json(const TestHeading& heading, const char* mode) {
  return {{"type", "test"},           {"mode", mode},
          {"id", heading.id},         {"trial", heading.trial},
          {"seed", heading.seed},     {"duration", heading.duration},
          {"period", heading.period}, {"periods", heading.periods}};
}

Json commands_json(const Hello& hello, std::span<const double> commands) {
  Json list = Json::array();
  for (std::size_t a = 0; a < commands.size(); ++a) {
    const TargetActuator& actuator = hello.actuators[a];  // a limit there and back may have gained a digit
    list.push_back(std::clamp(commands[a] / actuator.to_si, actuator.sent_lower, actuator.sent_upper));
  }
  return list;
}

/// Whether it is a list of `size` numbers; null counts as one where it may stand for a missing one.
bool is_list_of_numbers(const Json& json, std::size_t size, bool with_gaps) {
  if (!json.is_array() || json.size() != size) return false;
  for (const Json& item : json)
    if (!(item.is_number() || (with_gaps && item.is_null()))) return false;
  return true;
}

/// Readings, one a sensor.
std::vector<double> si_of(const Json& list, const Hello& hello) {
  std::vector<double> values;
  for (std::size_t c = 0; c < hello.sensors.size(); ++c)
    values.push_back(list[c].is_null() ? kMissing : list[c].get<double>() * hello.sensors[c].to_si);
  return values;
}

JointStarts read_start(JsonMessage& message) {
  JointStarts start;
  const Json* json = message.find("start");
  if (json == nullptr) return start;
  bool good = json->is_object();
  for (const auto& [joint, value] : json->items()) {
    const bool known =
        value.is_object() && value.value("position", Json()).is_number() && value.value("velocity", Json()).is_number();
    if (known) start[joint] = {value["position"].get<double>(), value["velocity"].get<double>()};
    good = good && known;
  }
  if (!good)
    message.add_fault(
        R"("start" is not an object of joints such as {"hinge": {"position": 0.1, "velocity": 0}}, in rad or m)");
  return start;
}

/// Times that grow.
Eigen::VectorXd read_times(const Json& json, JsonMessage& message) {
  if (!json.is_array() || json.empty() || !is_list_of_numbers(json, json.size(), false)) {
    message.add_fault("\"times\" is not a list of numbers, s");
    return {};
  }
  Eigen::VectorXd times(static_cast<Eigen::Index>(json.size()));
  for (std::size_t i = 0; i < json.size(); ++i) times[static_cast<Eigen::Index>(i)] = json[i].get<double>();
  for (Eigen::Index i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1])) {
      message.add_fault(fmt::format("\"times\" do not increase: {} follows {}", times[i], times[i - 1]));
      break;
    }
  return times;
}

/// A row a time, a value a sensor; null: not measured.
TimeSeries::Samples read_rows(const Json& json, const Eigen::VectorXd& times, const Hello& hello,
                              JsonMessage& message) {
  const std::size_t sensors = hello.sensors.size();
  TimeSeries::Samples rows(times.size(), static_cast<Eigen::Index>(sensors));
  if (!json.is_array() || json.size() != static_cast<std::size_t>(times.size())) {
    message.add_fault(fmt::format("\"samples\" is not a list of {} rows, one per time", times.size()));
    return rows;
  }
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    const Json& line = json[static_cast<std::size_t>(row)];
    if (!is_list_of_numbers(line, sensors, true)) {
      message.add_fault(fmt::format("\"samples\"[{}] is not a list of {}, one per sensor: {}", row,
                                    counted(sensors, "number"), quoted_text(line.dump())));
      return rows;
    }
    const std::vector<double> values = si_of(line, hello);
    for (std::size_t c = 0; c < sensors; ++c) rows(row, static_cast<Eigen::Index>(c)) = values[c];
  }
  return rows;
}

}  // namespace

std::string series_message(const TestHeading& heading, const Hello& hello, const CommandSeries& commands) {
  const TimeSeries& series = commands.series;
  Json rows = Json::array();
  for (Eigen::Index row = 0; row < series.samples.rows(); ++row)
    rows.push_back(commands_json(hello, {series.samples.row(row).data(), hello.actuators.size()}));
  Json message = heading_json(heading, "series");
  message["commands"] = {{"hold", commands.hold == Hold::first_order ? "first" : "zero"},
                         {"times", std::vector<double>(series.times.begin(), series.times.end())},
                         {"samples", std::move(rows)}};
  return message.dump();
}

std::string exchange_message(const TestHeading& heading) { return heading_json(heading, "exchange").dump(); }

std::string commands_message(const Hello& hello, std::span<const double> commands) {
  return Json{{"type", "commands"}, {"commands", commands_json(hello, commands)}}.dump();
}

Readings read_readings(const std::string& line, const Hello& hello, std::uint64_t id) {
  JsonMessage message(line, "readings", id);
  Readings readings;
  readings.time = message.number("time", "a number, s");
  const std::string meaning = fmt::format("a list of {} numbers, one per sensor", hello.sensors.size());
  const Json* sensors = message.need("sensors", meaning);
  if (sensors != nullptr && is_list_of_numbers(*sensors, hello.sensors.size(), true))
    readings.sensors = si_of(*sensors, hello);
  else if (sensors != nullptr)
    message.add_fault(fmt::format("\"sensors\" is not {}", meaning));
  readings.start = read_start(message);
  message.throw_if_faulty();
  return readings;
}

Samples read_samples(const std::string& line, const Hello& hello, std::uint64_t id) {
  JsonMessage message(line, "samples", id);
  Samples samples;
  const Json* times = message.need("times", "a list of numbers, s");
  const Json* rows = message.need("samples", "a list of rows, one per time");
  if (times != nullptr) samples.times = read_times(*times, message);
  if (rows != nullptr && samples.times.size() > 0) samples.values = read_rows(*rows, samples.times, hello, message);
  samples.start = read_start(message);
  message.throw_if_faulty();
  return samples;
}

}  // namespace lacuna
