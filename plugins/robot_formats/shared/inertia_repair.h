#pragma once

#include <Eigen/Core>

namespace lacuna::robot_files {

/// Whether an inertia is physically possible: symmetric, principal moments above 0, none above the sum of the others.
bool can_be(const Eigen::Matrix3d& inertia);

/// A possible inertia near an impossible one: principal moments that are too small are raised to a thousandth of the
/// largest; then one that is larger than the sum of the others is lowered and the others are raised by the same amount.
/// For a body of `mass`, kg, without further data: a ball of 5 cm.
Eigen::Matrix3d repaired(const Eigen::Matrix3d& inertia, double mass);

}  // namespace lacuna::robot_files
