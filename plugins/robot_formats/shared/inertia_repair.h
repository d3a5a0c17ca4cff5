#pragma once

#include <Eigen/Core>

namespace lacuna::robot_files {

/// Whether a body can have this inertia: symmetric, principal moments above 0, none above the sum of the others.
bool can_be(const Eigen::Matrix3d& inertia);

/// One that a body can have, near an inertia that none can: principal moments that are too small are raised to a
/// thousandth of the largest, then one that is larger than the sum of the others is lowered and these are raised, by as
/// much each. Of a body of `mass`, kg, of which nothing is known a ball of 5 cm.
Eigen::Matrix3d repaired(const Eigen::Matrix3d& inertia, double mass);

}  // namespace lacuna::robot_files
