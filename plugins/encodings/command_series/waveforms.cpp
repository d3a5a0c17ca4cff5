#include "waveforms.h"

#include <lacuna/random_stream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr int kMostLines = 32;
constexpr double kRounding = 1e-9;

enum Stream : std::uint64_t { kPhases = 1, kLevels = 2 };

RandomStream stream(Stream purpose, unsigned seed) { return RandomStream(std::array<std::uint64_t, 2>{purpose, seed}); }

double time_of(const WaveformTask& task, std::size_t sample) { return static_cast<double>(sample) * task.interval; }

void scale_to_one(std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (largest == 0.0) return;
  for (double& value : values) value /= largest;
}

/// Hz, ascending.
std::vector<double> lines(const WaveformTask& task) {
  const double first = std::ceil(task.low * task.duration - kRounding);
  const double last = std::floor(task.high * task.duration + kRounding);
  const double lowest = std::max(first, 1.0);
  std::vector<double> multiples;
  for (int i = 0; i < kMostLines && lowest <= last; ++i) {
    const double multiple = std::round(lowest * std::pow(last / lowest, i / (kMostLines - 1.0)));
    if (multiples.empty() || multiple > multiples.back()) multiples.push_back(multiple);
  }
  if (multiples.empty()) return {std::sqrt(task.low * task.high)};
  for (double& multiple : multiples) multiple /= task.duration;
  return multiples;
}

}  // namespace

std::vector<double> multisine(const WaveformTask& task) {
  std::vector<double> values(task.samples, 0.0);
  RandomStream random = stream(kPhases, task.seed);
  for (const double frequency : lines(task)) {
    const double phase = kTwoPi * random.uniform();
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] += std::sin(kTwoPi * frequency * time_of(task, k) + phase);
  }
  scale_to_one(values);
  return values;
}

std::vector<double> steps(const WaveformTask& task) {
  RandomStream random = stream(kLevels, task.seed);
  std::vector<double> levels(static_cast<std::size_t>(std::ceil(task.duration * task.low - kRounding)) + 1);
  for (double& level : levels) level = random.uniform(-1.0, 1.0);
  if (levels.size() > 1) levels.pop_back();
  scale_to_one(levels);
  std::vector<double> values;
  for (std::size_t k = 0; k < task.samples; ++k) {
    const auto held = static_cast<std::size_t>(time_of(task, k) * task.low + kRounding);
    values.push_back(levels[std::min(held, levels.size() - 1)]);
  }
  return values;
}

std::vector<double> chirp(const WaveformTask& task) {
  const double growth = std::log(task.high / task.low);
  std::vector<double> values;
  for (std::size_t k = 0; k < task.samples; ++k) {
    const double share = time_of(task, k) / task.duration;
    const double periods = growth > kRounding ? std::expm1(growth * share) / growth : share;
    values.push_back(std::sin(kTwoPi * task.low * task.duration * periods));
  }
  return values;
}

std::vector<double> triangle(const WaveformTask& task) {
  std::vector<double> values;
  for (std::size_t k = 0; k < task.samples; ++k) {
    const double period = time_of(task, k) * task.low + 0.25;
    values.push_back(1.0 - 4.0 * std::abs(period - std::floor(period) - 0.5));
  }
  return values;
}

}  // namespace lacuna
