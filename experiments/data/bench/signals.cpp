#include "bench/signals.h"

#include "bench/bench_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bench {

double multitone(std::span<const Tone> tones, double time) {
  double sum = 0.0;
  for (const Tone& tone : tones)
    sum += tone.amplitude * std::sin(2.0 * std::numbers::pi * tone.frequency * time + tone.phase);
  return sum;
}

double held_levels(std::span<const double> levels, double held, double time) {
  const std::size_t level = std::min(static_cast<std::size_t>(time / held), levels.size() - 2);
  const double since = time - held * static_cast<double>(level);
  return std::lerp(levels[level], levels[level + 1], ramp(since, 0.05));
}

}  // namespace bench
