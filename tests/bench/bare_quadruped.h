#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace lacuna {

/// The quadruped written straight against ODE, as one would for this robot alone: what the platform's generality is
/// measured by. Same bodies, joints, servos and contacts; it records the same readings.
class BareQuadruped {
 public:
  BareQuadruped();
  ~BareQuadruped();
  BareQuadruped(const BareQuadruped&) = delete;
  BareQuadruped& operator=(const BareQuadruped&) = delete;

  /// A trial from the start pose; afterwards `readings` holds a row a sample, the start included.
  void run(int steps);
  const std::vector<double>& readings() const { return readings_; }

 private:
  struct Parts;

  void reset();
  void drive(double time);
  void touch_ground();
  void record();

  std::unique_ptr<Parts> parts_;
  std::vector<double> readings_;
};

}  // namespace lacuna
