#include "measurement/trials/controller_plan.h"

#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace lacuna {
namespace {

std::optional<Eigen::Index> column_of(const std::vector<PlannedColumn>& planned, const std::string& channel) {
  const auto found = std::find_if(planned.begin(), planned.end(),
                                  [&](const PlannedColumn& one) { return one.channel.name == channel; });
  if (found == planned.end()) return std::nullopt;
  return found - planned.begin();
}

std::size_t index_of(const std::vector<Channel>& channels, const std::string& name) {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [&](const Channel& one) { return one.name == name; });
  return static_cast<std::size_t>(found - channels.begin());
}

std::string known(const std::vector<PlannedColumn>& planned) {
  std::string names;
  for (const PlannedColumn& one : planned) names += (names.empty() ? "" : ", ") + one.channel.name;
  return names.empty() ? "none" : names;
}

/// `command`·s^`seconds`/`sensor`.
void check_gain(const std::string& written, const Channel& command, const Channel& sensor, int seconds, const char* key,
                const ControllerMapping& mapping, ProblemList& problems) {
  const std::optional<Unit> gain = parse_unit(written.empty() ? "1" : written), wanted = parse_unit(command.unit),
                            per = parse_unit(sensor.unit), second = parse_unit("s");
  if (!gain || !wanted || !per) return;
  Unit product = *gain;
  for (std::size_t i = 0; i < product.exponents.size(); ++i)
    product.exponents[i] += per->exponents[i] - seconds * second->exponents[i];
  if (product.exponents == wanted->exponents) return;
  const std::string unit = fmt::format("{}{}/{}", command.unit, seconds > 0 ? "*s" : "",
                                       seconds < 0 ? fmt::format("({}*s)", sensor.unit) : sensor.unit);
  problems.add(mapping.location,
               fmt::format("{} of the controller of {} turns {} into {}, so its unit is {}, as in \"8 {}\"", key,
                           mapping.actuator, sensor.unit, command.unit, unit, unit));
}

}  // namespace

void plan_controllers(const std::vector<ControllerMapping>& controllers, const std::vector<Channel>& channels,
                      const std::vector<Channel>& actuators, RecordingPlan& plan, ProblemList& problems) {
  for (const PlannedColumn& command : plan.commands)
    plan.actuator_of.push_back(index_of(actuators, command.channel.name));
  for (const ControllerMapping& mapping : controllers) {
    const std::optional<Eigen::Index> command = column_of(plan.commands, mapping.actuator),
                                      reading = column_of(plan.sensors, mapping.sensor);
    if (!command)
      problems.add(mapping.location, fmt::format("target.controllers names the actuator `{}`, which has no column in "
                                                 "target.commands; actuators with a column: {}",
                                                 mapping.actuator, known(plan.commands)));
    if (!reading)
      problems.add(
          mapping.location,
          fmt::format(
              "the controller of {} reads `{}`, which has no column in target.sensors; sensors with a column: {}",
              mapping.actuator, mapping.sensor, known(plan.sensors)));
    if (!command || !reading) continue;
    const Channel &sensor = plan.sensors[static_cast<std::size_t>(*reading)].channel,
                  &driven = plan.commands[static_cast<std::size_t>(*command)].channel;
    if (mapping.proportional != 0.0)
      check_gain(mapping.proportional_unit, driven, sensor, 0, "proportional", mapping, problems);
    if (mapping.derivative != 0.0)
      check_gain(mapping.derivative_unit, driven, sensor, 1, "derivative", mapping, problems);
    if (mapping.integral != 0.0) check_gain(mapping.integral_unit, driven, sensor, -1, "integral", mapping, problems);
    const std::vector<PlannedColumn> reference =
        plan_columns({mapping.reference}, {{mapping.actuator, sensor.unit}}, "controller", problems);
    plan.references.push_back({reference.front().channel, &mapping.reference, reference.front().factor});
    plan.laws.push_back({index_of(actuators, mapping.actuator), index_of(channels, mapping.sensor), *command, *reading,
                         mapping.proportional, mapping.derivative, mapping.integral, mapping.limit, mapping.filter});
  }
}

}  // namespace lacuna
