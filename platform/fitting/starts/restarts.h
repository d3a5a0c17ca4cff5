#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/trial.h>

namespace lacuna {

/// Length of a trial's prediction before it restarts from the readings, s; infinite: to its end.
///
/// Torques without a controller are integrated twice: where recorded torques or forces drive at least `kFewestDriven`
/// joints of one chain and no controller closes the loop, an error of the model grows without bound, and the prediction
/// of a whole recording does not assess the model and takes long to compute.
double restart_interval(const RobotSpec& robot, const Trial& trial);

inline constexpr int kFewestDriven = 3;  ///< joints from the base to a body
inline constexpr double kRestart = 1.0;  ///< s

}  // namespace lacuna
