#include "process/hello.h"

#include "foundation/text/problem.h"
#include "foundation/unit.h"
#include "process/json_message.h"
#include "process/quoted_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using Json = nlohmann::json;

constexpr double kLimitTolerance = 1e-9;  // relative, of what units and decimal places do to a limit

constexpr const char* kWithoutIds = "lacuna-process/1";
constexpr const char* kAddIds =
    R"(: let each of its answers to a test repeat the "id" of the test's message, and its hello name this protocol)";

/// One of the objects in a list of the hello; its faults are the hello's.
class Part {
 public:
  Part(const Json& json, const std::string& where, JsonMessage& message)
      : json_(json), where_(where), message_(message) {
    if (!json.is_object()) fault("is not an object");
  }

  std::string text(const char* name) {
    const auto found = json_.is_object() ? json_.find(name) : json_.end();
    if (found != json_.end() && found->is_string() && !found->get<std::string>().empty())
      return plain_text(found->get<std::string>());
    if (json_.is_object()) fault(fmt::format("has no text \"{}\"", name));
    return {};
  }

  double number(const char* name, bool needed) {
    const auto found = json_.is_object() ? json_.find(name) : json_.end();
    if (found != json_.end() && found->is_number() && std::isfinite(found->get<double>())) return found->get<double>();
    if (json_.is_object() && (needed || found != json_.end())) fault(fmt::format("has no number \"{}\"", name));
    return std::numeric_limits<double>::quiet_NaN();
  }

  double factor_of(const std::string& unit) {
    if (unit.empty()) return 1.0;
    if (const std::optional<Unit> known = parse_unit(unit)) return known->to_si;
    fault(fmt::format("has the unknown unit {}; known units are {}", quoted_text(unit), known_units()));
    return 1.0;
  }

  void fault(const std::string& what) { message_.add_fault(where_ + " " + what); }

 private:
  const Json& json_;
  std::string where_;
  JsonMessage& message_;
};

TargetSensor read_sensor(Part part) {
  TargetSensor sensor{part.text("name"), part.text("unit")};
  sensor.to_si = part.factor_of(sensor.unit);
  sensor.noise = part.number("noise", false) * sensor.to_si;
  if (sensor.noise < 0.0) part.fault("has a \"noise\" below zero");
  const double lower = part.number("lower", false) * sensor.to_si, upper = part.number("upper", false) * sensor.to_si;
  if (!std::isnan(lower)) sensor.lower = lower;
  if (!std::isnan(upper)) sensor.upper = upper;
  if (sensor.lower >= sensor.upper) part.fault("has a \"lower\" reading that is not below its \"upper\" reading");
  return sensor;
}

TargetActuator read_actuator(Part part) {
  TargetActuator actuator{part.text("name"), part.text("unit")};
  actuator.to_si = part.factor_of(actuator.unit);
  actuator.sent_lower = part.number("lower", true);
  actuator.sent_upper = part.number("upper", true);
  actuator.lower = actuator.sent_lower * actuator.to_si;
  actuator.upper = actuator.sent_upper * actuator.to_si;
  if (actuator.lower >= actuator.upper) part.fault("has a \"lower\" limit that is not below its \"upper\" limit");
  return actuator;
}

template <class Described>
std::vector<Described> read_list(JsonMessage& message, const std::string& name, Described (*read)(Part)) {
  std::vector<Described> channels;
  const Json* list = message.need(name, "a list of objects");
  if (list == nullptr) return channels;
  if (!list->is_array()) {
    message.add_fault(fmt::format("\"{}\" is not a list", name));
    return channels;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    channels.push_back(read(Part((*list)[i], fmt::format("{}[{}]", name, i), message)));
    const auto same = [&](const Described& other) { return other.name == channels.back().name; };
    if (std::count_if(channels.begin(), channels.end(), same) > 1 && !channels.back().name.empty())
      message.add_fault(fmt::format("{}[{}] repeats the name {}", name, i, quoted_text(channels.back().name)));
  }
  return channels;
}

void read_modes(JsonMessage& message, Hello& hello) {
  const std::string meaning = "a list of \"series\", \"exchange\" or both";
  const Json* modes = message.need("modes", meaning);
  if (modes == nullptr) return;
  bool good = modes->is_array() && !modes->empty();
  for (const Json& mode : good ? *modes : Json::array()) {
    hello.takes_series = hello.takes_series || mode == "series";
    hello.exchanges = hello.exchanges || mode == "exchange";
    good = good && (mode == "series" || mode == "exchange");
  }
  if (!good) message.add_fault("\"modes\" is not " + meaning);
}

template <class Described>
std::vector<std::string> names_of(const std::vector<Described>& channels) {
  std::vector<std::string> names;
  for (const Described& channel : channels) names.push_back(channel.name);
  return names;
}

template <class Named>
const Named* find_channel(const std::vector<Named>& channels, const std::string& name) {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [&](const Named& channel) { return channel.name == name; });
  return found == channels.end() ? nullptr : &*found;
}

/// The target's channel for a channel of the model; null, with a fault, if none has its name and dimension.
template <class Described>
const Described* counterpart(const std::vector<Described>& channels, const Channel& wanted, const std::string& noun,
                             std::vector<std::string>& complaints) {
  const Described* found = find_channel(channels, wanted.name);
  if (found == nullptr) {
    const std::vector<std::string> names = names_of(channels);
    complaints.push_back(
        fmt::format("the model has the {0} \"{1}\", which the target does not have{2}; the target's {0}s are {3}", noun,
                    wanted.name, did_you_mean(wanted.name, names),
                    names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    return found;
  }
  const std::optional<Unit> own = parse_unit(found->unit), models = parse_unit(wanted.unit);
  if (own && models && !own->same_dimension(*models)) {
    complaints.push_back(
        fmt::format("the target's {} \"{}\" is in {}, the model's in {}; correct the unit in the program, or the model",
                    noun, wanted.name, found->unit, wanted.unit));
    return nullptr;
  }
  return found;
}

void compare_limits(const TargetActuator& actuator, const TestSpace& space, std::size_t index,
                    std::vector<std::string>& complaints) {
  const double slack = kLimitTolerance * (actuator.upper - actuator.lower);
  if (space.lower[index] >= actuator.lower - slack && space.upper[index] <= actuator.upper + slack) return;
  complaints.push_back(fmt::format(
      "the model may command \"{0}\" from {1:.4g} to {2:.4g} {5}, the target takes {3:.4g} to {4:.4g} {5}; give the "
      "model's actuator these limits, with command_lower and command_upper",
      actuator.name, space.lower[index], space.upper[index], actuator.lower, actuator.upper,
      space.actuators[index].unit));
}

}  // namespace

std::string hello_message() { return Json{{"type", "hello"}, {"protocol", kProcessProtocol}}.dump(); }

Hello read_hello(const std::string& line) {
  JsonMessage message(line, "hello");
  const std::string protocol = message.text("protocol", "a text");
  if (!protocol.empty() && protocol != kProcessProtocol)
    message.add_fault(fmt::format("it speaks {}, this program {}{}", quoted_text(protocol), kProcessProtocol,
                                  protocol == kWithoutIds ? kAddIds : ""));
  Hello hello;
  hello.name = message.text("name", "a text");
  read_modes(message, hello);
  hello.sensors = read_list<TargetSensor>(message, "sensors", read_sensor);
  hello.actuators = read_list<TargetActuator>(message, "actuators", read_actuator);
  message.throw_if_faulty();
  return hello;
}

std::vector<std::string> misfits(const Hello& hello, const TestSpace& space) {
  std::vector<std::string> complaints;
  for (const Channel& sensor : space.sensors) counterpart(hello.sensors, sensor, "sensor", complaints);
  for (std::size_t a = 0; a < space.actuators.size(); ++a)
    if (const TargetActuator* actuator = counterpart(hello.actuators, space.actuators[a], "actuator", complaints))
      compare_limits(*actuator, space, a, complaints);
  for (const TargetActuator& actuator : hello.actuators)
    if (find_channel(space.actuators, actuator.name) == nullptr)
      complaints.push_back(
          fmt::format("the target has the actuator \"{}\", which the model does not have, so it would get no commands; "
                      "add it to the model's "
                      "robot",
                      actuator.name));
  return complaints;
}

}  // namespace lacuna
