#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/trial.h>

namespace lacuna {

/// How long a trial is predicted before the prediction starts anew from the readings, s; infinite: to its end.
///
/// Torques that nothing corrects are integrated twice: where at least `kFewestDriven` joints of one chain are driven by
/// recorded torques or forces and no controller closes the loop, an error of the model grows without bound, and a
/// prediction of a whole recording says nothing of the model and takes long to compute.
double restart_interval(const RobotSpec& robot, const Trial& trial);

inline constexpr int kFewestDriven = 3;  ///< joints from the base to a body
inline constexpr double kRestart = 1.0;  ///< s

}  // namespace lacuna
