#pragma once

#include "data_checks/doubt.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Readings of joints that are a simple factor too large or too small.
struct ReadingScale {
  std::vector<std::string> channels;  ///< whose readings have the factor
  std::string unit;                   ///< of the first, rad or m
  double factor = 1.0;                ///< readings over what they should be: 0.25 where a quarter is read
  std::string cause;                  ///< "as where degrees are read as radians"
  double before = 0.0, after = 0.0;   ///< share of the squared accelerations that is left unexplained
};

/// What gravity tells of the readings' scale, with the model as written and none of it fitted. An angle's gravity
/// torque is not proportional to it, so that a wrong factor leaves accelerations that no inertia, stiffness, damping,
/// friction, offset or gain of a command explains, and that the right one explains together with the model's own
/// masses. A fall without drive is as fast as gravity says. Small swings tell nothing, and nothing is said of them.
/// Only factors that units, counts per turn and gears may have are looked at.
std::optional<ReadingScale> reading_scale(const DoubtTask& task);

/// Result, reason and what to do, without the line to type.
std::string to_string(const ReadingScale& scale);

}  // namespace lacuna
