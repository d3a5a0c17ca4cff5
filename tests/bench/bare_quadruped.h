#pragma once

#include "support/quadruped_for_bench.h"

#include <memory>
#include <vector>

namespace lacuna {

/// The quadruped written straight against ODE, as one would for this robot alone: what the platform's generality is
/// measured by. Same bodies, joints, servos and contacts; it records the same readings.
class BareQuadruped {
 public:
  explicit BareQuadruped(const QuadrupedNumbers& numbers);
  ~BareQuadruped();
  BareQuadruped(const BareQuadruped&) = delete;
  BareQuadruped& operator=(const BareQuadruped&) = delete;

  /// A trial from the start pose; afterwards `readings` holds `kReadings` values a sample, the start included.
  void run(int steps);
  const std::vector<double>& readings() const { return readings_; }

  static constexpr int kReadings = 2 * kLegs + 3;

 private:
  struct Parts;

  void reset();
  void drive(double time);
  void touch_ground();
  void record();

  QuadrupedNumbers numbers_;
  std::unique_ptr<Parts> parts_;
  std::vector<double> readings_;
};

}  // namespace lacuna
