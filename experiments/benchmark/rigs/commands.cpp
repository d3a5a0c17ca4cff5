#include "rigs/rig.h"

#include "plant/coordinates.h"
#include "plant/draw.h"

#include <cmath>
#include <numbers>

namespace hidden_effects {
namespace {

constexpr double kRest = 0.2;  ///< s, before anything happens
constexpr double kRise = 0.3;  ///< s, in which a command reaches its size

double risen(double time) { return time >= kRise ? 1.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * time / kRise); }

/// Eight tones with frequencies spread evenly on a logarithmic scale; RMS 1.
class Multisine {
 public:
  Multisine(double slowest, double fastest, Draw& draw) {
    for (int k = 0; k < kTones; ++k) {
      frequency_[k] = slowest * std::pow(fastest / slowest, (k + draw.uniform()) / kTones);
      phase_[k] = kTurn * draw.uniform();
    }
  }
  double operator()(double time) const {
    double sum = 0.0;
    for (int k = 0; k < kTones; ++k) sum += std::sin(kTurn * frequency_[k] * time + phase_[k]);
    return sum * std::sqrt(2.0 / kTones);
  }

 private:
  static constexpr int kTones = 8;
  double frequency_[kTones], phase_[kTones];
};

/// Levels held for half a second on average, to and fro: what nothing holds would drift away otherwise.
std::vector<double> held_levels(std::size_t samples, double interval, Draw& draw) {
  std::vector<double> values;
  double sign = draw.uniform() < 0.5 ? -1.0 : 1.0;
  while (values.size() < samples) {
    const double level = sign * draw.between(0.3, 1.5);
    const auto held = static_cast<std::size_t>(draw.between(0.25, 0.75) / interval);
    values.insert(values.end(), held, level);
    sign = -sign;
  }
  values.resize(samples);
  return values;
}

double chirp(double time, double duration, double slowest, double fastest, double phase) {
  const double rate = (fastest - slowest) / duration;
  return std::numbers::sqrt2 * std::sin(kTurn * (slowest * time + 0.5 * rate * time * time + phase));
}

double triangle(double place) { return 4.0 * std::abs(place - std::floor(place) - 0.5) - 1.0; }

}  // namespace

std::vector<std::vector<double>> commands(const Rig& rig, int kind, double duration, std::uint64_t seed) {
  const auto samples = static_cast<std::size_t>(std::lround(duration / rig.interval)) + 1;
  std::vector<std::vector<double>> all;
  for (std::size_t d = 0; d < rig.nominal.drives.size(); ++d) {
    Draw draw(seed, 100 + d);
    const Multisine tones(rig.scales.slowest, rig.scales.fastest, draw);
    const std::vector<double> levels = held_levels(samples, rig.interval, draw);
    const double first = draw.uniform();
    std::vector<double> values(samples, 0.0);
    for (std::size_t k = 0; k < samples; ++k) {
      const double time = static_cast<double>(k) * rig.interval - kRest;
      if (time <= 0.0) continue;
      double value = 0.0;
      if (kind == 0) value = tones(time);
      if (kind == 1) value = levels[k];
      if (kind == 2) value = chirp(time, duration, rig.scales.slowest, rig.scales.fastest, first);
      if (kind == 3) value = 1.4 * triangle(first + 1.5 * rig.scales.slowest * time) + 0.3 * tones(time);
      values[k] = rig.scales.amplitude[d] * risen(time) * value;
    }
    all.push_back(std::move(values));
  }
  return all;
}

}  // namespace hidden_effects
