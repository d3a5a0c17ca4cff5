#pragma once

#include "data_checks/data_warning.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Readings of a joint that are too large or too small by a simple factor.
struct ReadingScale {
  std::vector<std::string> channels;  ///< whose readings have the factor
  std::string unit;                   ///< of the first, rad or m
  double factor = 1.0;                ///< readings over true values: 0.25 where a quarter is read
  std::string cause;                  ///< "as if degrees were read as radians"
  double before = 0.0, after = 0.0;   ///< share of the squared accelerations that remains unexplained
};

/// Finds the scale of the readings from gravity, with the model as written and no fitted mass. The gravity torque is
/// not proportional to the angle: a wrong factor leaves accelerations that no inertia, stiffness, damping, friction,
/// offset or command gain explains, and the right factor explains them with the model's own masses. An undriven fall
/// has the acceleration of gravity. Small swings do not determine the factor, and give no result. Only factors of
/// units, counts per turn and gears are tried.
std::optional<ReadingScale> reading_scale(const DataCheckTask& task);

/// Result, reason and what to do, without the line to type.
std::string to_string(const ReadingScale& scale);

}  // namespace lacuna
