#pragma once

#include <cstdint>
#include <random>

/// What the computed benches of this folder share: noise that is the same everywhere, and the file of a recorder.
namespace bench {

/// Standard normal numbers that are the same with every standard library (whose own distributions are not): Box and
/// Muller.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : bits_(seed) {}
  double operator()();

 private:
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1.0p-53; }
  std::mt19937_64 bits_;
};

/// A stationary Ornstein–Uhlenbeck process, sampled exactly at intervals of `interval` s: a random torque in N·m with
/// the given standard deviation and correlation time in s.
class Disturbance {
 public:
  Disturbance(double deviation, double time, double interval, std::uint64_t seed);
  double value() const { return value_; }
  void next();

 private:
  double deviation_, memory_;
  Normal normal_;
  double value_;
};

/// The multiple of `quantum` next to `value`; never −0.
double rounded(double value, double quantum);

/// Rises smoothly from 0 to 1 within `rise` seconds of `time` = 0.
double ramp(double time, double rise);

}  // namespace bench
