#pragma once

#include <lacuna/robot_spec.h>

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// The changes that make one robot into another.
struct RobotComparison {
  std::map<std::string, double> set;  ///< values of `wanted` by address, where the other robot's differ
  std::vector<std::string> other;     ///< sentences: elements that only one of them has, and other places or kinds
};

/// Frames of bodies may differ: mass properties are compared in space. Numbers count as equal to twelve digits, places
/// to a nanometre. Where a mass differs, the whole inertia is set, because setting a mass changes it.
RobotComparison compare_robots(const RobotSpec& wanted, const RobotSpec& other);

}  // namespace lacuna
