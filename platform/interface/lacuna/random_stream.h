#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

namespace lacuna {

/// Random numbers that depend only on a key, such as (run seed, phase, pass, generation, individual). Streams with
/// different keys are independent, so the order of drawing does not matter and no state need be stored to continue.
/// Philox-like use of splitmix64 (Steele, Lea and Flood, 2014): the key is scrambled into a start, and a counter is
/// scrambled from there. Satisfies `std::uniform_random_bit_generator`; not for secrets. One thread at a time.
class RandomStream {
 public:
  using result_type = std::uint64_t;

  explicit RandomStream(std::span<const std::uint64_t> key) {
    for (const std::uint64_t part : key) state_ = scramble(state_ ^ scramble(part + kGamma));
  }

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~result_type{0}; }
  result_type operator()() { return scramble(state_ += kGamma); }

  /// Uniform in (0, 1).
  double uniform() { return (static_cast<double>((*this)() >> 11) + 0.5) * 0x1.0p-53; }
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
  /// Uniform in 0 ... count − 1; `count` must be far below 2⁵³.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }
  bool chance(double probability) { return uniform() < probability; }
  /// Mean 0, standard deviation 1 (Box and Muller, 1958).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  static constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15ULL;
  static constexpr std::uint64_t scramble(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  std::uint64_t state_ = 0;
};

}  // namespace lacuna
