#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace lacuna {

/// Random numbers that depend on a seed and a stream alone, not on a library: splitmix64 (Steele, Lea and
/// Flood, 2014), and Box and Muller's transform.
class SeededNoise {
 public:
  SeededNoise(std::uint64_t seed, std::uint64_t stream) : state_(scramble(seed) ^ scramble(stream + kGamma)) {}

  /// Uniform in (0, 1).
  double uniform() { return (static_cast<double>(next() >> 11) + 0.5) * 0x1.0p-53; }
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
  /// Mean 0, standard deviation 1.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  static constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15ULL;
  static std::uint64_t scramble(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t next() { return scramble(state_ += kGamma); }

  std::uint64_t state_;
};

}  // namespace lacuna
