#include "simulation/shared/sensor_imperfections.h"

#include <cmath>
#include <numbers>

namespace lacuna::simulation {
namespace {

constexpr double kTicksPerStep = 1024.0;  // resolution of sample times

std::uint64_t mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

/// In (0, 1].
double unit_interval(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 1.0) * 0x1.0p-53; }

}  // namespace

double keyed_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
  const std::uint64_t key = mix(mix(mix(seed) ^ stream) ^ counter);
  const double radius = std::sqrt(-2.0 * std::log(unit_interval(mix(key))));
  return radius * std::cos(2.0 * std::numbers::pi * unit_interval(mix(key + 1)));
}

void add_imperfections(const std::vector<SensorSpec>& sensors, std::span<const std::size_t> first_channel,
                       std::uint64_t seed, double time, double step, std::span<double> readings) {
  const auto tick = static_cast<std::uint64_t>(std::llround(time / step * kTicksPerStep));
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const SensorSpec& sensor = sensors[i];
    for (std::size_t channel = first_channel[i]; channel < first_channel[i + 1]; ++channel) {
      if (sensor.noise > 0.0) readings[channel] += sensor.noise * keyed_normal(seed, channel, tick);
      if (sensor.quantum > 0.0) readings[channel] = sensor.quantum * std::round(readings[channel] / sensor.quantum);
    }
  }
}

}  // namespace lacuna::simulation
