#pragma once

#include "data_checks/acceleration_table.h"

#include <string>
#include <vector>

namespace lacuna {

/// The accelerations of one channel, all trials below each other; rows over their noise.
struct StackedAccelerations {
  std::string channel, unit;
  Eigen::VectorXd measured;
  Eigen::MatrixXd beside;     ///< surroundings (command_lags.h)
  Eigen::MatrixXd commanded;  ///< by actuator
  double deviation = 0.0;     ///< noise of the first trial, by about which each row was divided
};

/// In the order of the table's channels.
std::vector<StackedAccelerations> stacked(const AccelerationTable& table);

/// The share of the squared accelerations that surroundings and commands, in any proportion, leave unexplained; 1 for
/// an empty table.
double unexplained_share(const AccelerationTable& table);

}  // namespace lacuna
