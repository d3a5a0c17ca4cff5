#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/trial.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace lacuna {

/// Where the bodies of a robot start, one row a body (x, y, z in the world, m), as their ranges to at least three
/// beacons say it, without any model: the mean of each range at the trials' first samples, horizontal places by least
/// squares from differences of squared ranges, heights from what is left of the ranges. Beacons are to be at one
/// height; of the two reflections in their plane the upper one counts. Nothing where some body has too few ranges, or
/// beacons on a line.
std::optional<Eigen::MatrixX3d> trilaterated_centres(const RobotSpec& robot, const std::vector<Trial>& trials);

}  // namespace lacuna
