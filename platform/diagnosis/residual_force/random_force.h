#pragma once

#include <string>

namespace lacuna {

/// A random force that the residual shows.
struct RandomForce {
  std::string joint;
  std::string unit;
  double deviation = 0.0;  ///< standard deviation of its mean over `duration`
  double duration = 0.0;   ///< s
  bool slow = false;       ///< correlated over `duration`; else it keeps its value for that long
  bool operator==(const RandomForce&) const = default;
};

/// s: the correlation time at which a force of the same deviation has the same power at low frequencies.
double correlation_time(const RandomForce& force);

/// Of what a force does to a motion, roughly: its power at low frequencies, N²·s or (N·m)²·s.
double power(const RandomForce& force);

}  // namespace lacuna
