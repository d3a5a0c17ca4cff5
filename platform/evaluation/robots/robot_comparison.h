#pragma once

#include <lacuna/robot_spec.h>

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// What has to be said of a robot to make another one of it.
struct RobotComparison {
  std::map<std::string, double> set;  ///< values of `wanted` by address, where the other has others
  std::vector<std::string> other;     ///< sentences: elements that only one of them has, and other places or kinds
};

/// Frames of bodies may stand elsewhere: masses are compared where they are. Numbers count as equal to twelve digits,
/// places to a nanometre. Where a mass differs all of the inertia is set, which follows a mass that is set.
RobotComparison compare_robots(const RobotSpec& wanted, const RobotSpec& other);

}  // namespace lacuna
