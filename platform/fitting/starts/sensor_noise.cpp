#include "fitting/starts/sensor_noise.h"

#include "foundation/statistics.h"
#include "foundation/address.h"
#include "foundation/unit.h"
#include "measurement/line_departures.h"
#include "measurement/rest_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace lacuna {
namespace {

struct Figure {
  double deviation = 0.0;
  std::string origin;
  bool is_guess = false;
};

/// RMS of the noise that the columns of the trials declare.
std::optional<Figure> declared_by_columns(const std::vector<Trial>& trials, const std::string& name) {
  double squares = 0.0;
  int count = 0;
  for (const Trial& trial : trials)
    for (std::size_t i = 0; i < trial.sensor_noise.size() && i < trial.measured.channels.size(); ++i)
      if (trial.measured.channels[i].name == name && std::isfinite(trial.sensor_noise[i])) {
        squares += trial.sensor_noise[i] * trial.sensor_noise[i];
        ++count;
      }
  if (count == 0 || squares == 0.0) return std::nullopt;
  return Figure{std::sqrt(squares / count), "declared for the column"};
}

std::optional<Figure> declared_by_robot(const RobotSpec& robot, const Channel& channel) {
  for (const SensorSpec& sensor : robot.sensors) {
    const std::vector<Channel> channels = sensor_channels(robot, sensor);
    if (std::find(channels.begin(), channels.end(), channel) == channels.end()) continue;
    if (sensor.noise <= 0.0 && sensor.quantum <= 0.0) return std::nullopt;
    const std::string step = "encoder step " + format_quantity(sensor.quantum, channel.unit) + "/√12";
    const double deviation = std::hypot(sensor.noise, sensor.quantum / std::sqrt(12.0));
    if (sensor.noise <= 0.0) return Figure{deviation, step};
    return Figure{deviation, sensor.quantum > 0.0 ? "declared by the robot's sensor, with " + step
                                                  : "declared by the robot's sensor"};
  }
  return std::nullopt;
}

std::optional<Figure> found_at_rest(const std::vector<Trial>& trials, const Channel& channel) {
  const SensorNoise found = estimate_sensor_noise(trials, channel.name);
  if (!(found.standard_deviation > 0.0)) return std::nullopt;
  return Figure{found.standard_deviation, found.origin(channel.unit)};
}

Figure from_second_differences(const std::vector<Trial>& trials, const std::string& name) {
  std::vector<double> departures;
  double largest = 0.0;
  for (const Trial& trial : trials)
    for (std::size_t i = 0; i < trial.measured.channels.size(); ++i) {
      if (trial.measured.channels[i].name != name) continue;
      const auto column = trial.measured.samples.col(static_cast<Eigen::Index>(i));
      const std::vector<double> values(column.begin(), column.end());
      for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
      const std::span times(trial.measured.times.data(), values.size());
      for (const double departure : line_departures(times, values)) departures.push_back(std::abs(departure));
    }
  double deviation = 0.0;
  if (!departures.empty()) {
    deviation = 1.4826 * median_of(departures);
    if (deviation == 0.0) {  // a coarse quantiser: most second differences vanish
      double squares = 0.0;
      for (const double departure : departures) squares += departure * departure;
      deviation = std::sqrt(squares / static_cast<double>(departures.size()));
    }
  }
  const double resolution = std::numeric_limits<double>::epsilon() * std::max(largest, 1e-6);
  if (deviation > resolution)
    return {deviation,
            "from second differences of the recording, because no noise is declared and the channel never rests; fast "
            "motion counts as noise",
            true};
  return {resolution, "rounding error; the recording shows no noise", true};
}

const SensorSpec* touch_sensor(const RobotSpec& robot, const std::string& channel) {
  for (const SensorSpec& sensor : robot.sensors)
    if (sensor.kind == SensorKind::touch && sensor.name == channel) return &sensor;
  return nullptr;
}

/// A touch has two readings and is exactly right except at changes, whose time is known to a sample: beside each change
/// one reading is as likely wrong as right. For a foot that never changes, one change is assumed.
Figure from_switches(const std::vector<Trial>& trials, const SensorSpec& sensor) {
  double switches = 0.0, samples = 0.0;
  for (const Trial& trial : trials)
    for (std::size_t i = 0; i < trial.measured.channels.size(); ++i) {
      if (trial.measured.channels[i].name != sensor.name) continue;
      double before = std::numeric_limits<double>::quiet_NaN();
      for (const double value : trial.measured.samples.col(static_cast<Eigen::Index>(i))) {
        if (!std::isfinite(value)) continue;
        samples += 1.0;
        if (std::isfinite(before) && (before < sensor.offset) != (value < sensor.offset)) switches += 1.0;
        before = value;
      }
    }
  const double apart = 2.0 * std::abs(sensor.scale);
  const double share = 0.5 * std::max(switches, 1.0) / std::max(samples, 1.0);
  return {apart * std::sqrt(share), "the sample beside each change of touch is uncertain"};
}

ChannelNoise noise_of(const RobotSpec& robot, const std::vector<Trial>& trials, const Channel& channel) {
  std::optional<Figure> figure = declared_by_columns(trials, channel.name);
  if (!figure) figure = declared_by_robot(robot, channel);
  const SensorSpec* touch = touch_sensor(robot, channel.name);
  if (!figure && touch && touch->scale != 0.0) figure = from_switches(trials, *touch);
  if (!figure) figure = found_at_rest(trials, channel);
  if (!figure) figure = from_second_differences(trials, channel.name);
  return {channel.name, channel.unit, figure->deviation, figure->origin, figure->is_guess};
}

}  // namespace

std::vector<ChannelNoise> sensor_noise(const RobotSpec& robot, const std::vector<Trial>& trials) {
  std::vector<ChannelNoise> all;
  for (const Trial& trial : trials)
    for (const Channel& channel : trial.measured.channels) {
      const bool known =
          std::any_of(all.begin(), all.end(), [&](const ChannelNoise& noise) { return noise.channel == channel.name; });
      if (!known) all.push_back(noise_of(robot, trials, channel));
    }
  return all;
}

}  // namespace lacuna
