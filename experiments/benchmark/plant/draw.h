#pragma once

#include "bench/bench_noise.h"

#include <cstdint>
#include <random>

namespace hidden_effects {

/// Mixes two numbers into the seed of a stream of its own (S. Vigna's splitmix64).
inline std::uint64_t mixed(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t z = seed + 0x9E3779B97F4A7C15ull * (stream + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

/// Uniform numbers, the same with every standard library.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t stream) : bits_(mixed(seed, stream)) {}
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1.0p-53; }  ///< in [0, 1)
  double between(double lower, double upper) { return lower + (upper - lower) * uniform(); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }

 private:
  std::mt19937_64 bits_;
};

}  // namespace hidden_effects
