#pragma once

#include <lacuna/engine_settings.h>

#include "simulation/shared/state_archive.h"

#include <algorithm>
#include <vector>

namespace lacuna::simulation {

/// A delay in integration steps: `whole` steps and a `fraction` in [0, 1).
struct Delay {
  std::size_t whole = 0;
  double fraction = 0.0;
  bool none() const { return whole == 0 && fraction == 0.0; }
};

/// `seconds` in integration steps of `settings`, rounded according to the settings.
Delay make_delay(double seconds, const EngineSettings& settings);

/// The last values of a signal that is sampled, or held, once per integration step. Linear interpolation between two
/// samples is the exact delay of a sampled signal, and the exact mean over the step of a delayed held one.
class DelayLine {
 public:
  /// Capacity for delays up to `longest`.
  explicit DelayLine(const Delay& longest) : values_(longest.none() ? 0 : longest.whole + 2) {}

  bool reaches(const Delay& delay) const { return delay.none() || delay.whole + 2 <= values_.size(); }
  void fill(double value) { std::fill(values_.begin(), values_.end(), value); }
  void push(double value) {
    if (values_.empty()) return;
    newest_ = newest_ + 1 == values_.size() ? 0 : newest_ + 1;
    values_[newest_] = value;
  }
  /// The value `delay` before the newest.
  double read(const Delay& delay) const {
    const double later = values_[back(delay.whole)];
    if (delay.fraction == 0.0) return later;
    return later + delay.fraction * (values_[back(delay.whole + 1)] - later);
  }

  std::size_t size() const { return values_.size(); }
  void save(StateWriter& writer) const;
  void load(StateReader& reader);

 private:
  std::size_t back(std::size_t steps) const {
    return newest_ >= steps ? newest_ - steps : newest_ + values_.size() - steps;
  }

  std::vector<double> values_;  // a ring
  std::size_t newest_ = 0;
};

}  // namespace lacuna::simulation
