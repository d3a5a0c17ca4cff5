#include "bench/bench_noise.h"

#include <cmath>
#include <numbers>

namespace bench {

double Normal::operator()() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

Disturbance::Disturbance(double deviation, double time, double interval, std::uint64_t seed)
    : deviation_(deviation), memory_(std::exp(-interval / time)), normal_(seed), value_(deviation_ * normal_()) {}

void Disturbance::next() { value_ = memory_ * value_ + deviation_ * std::sqrt(1.0 - memory_ * memory_) * normal_(); }

double rounded(double value, double quantum) { return quantum * std::round(value / quantum) + 0.0; }

double ramp(double time, double rise) {
  return time <= 0.0 ? 0.0 : time >= rise ? 1.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * time / rise);
}

}  // namespace bench
