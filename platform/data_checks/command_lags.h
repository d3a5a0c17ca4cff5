#pragma once

#include "data_checks/acceleration_table.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

inline constexpr double kSteadyLag = 0.5;  ///< of a lag: one that differs by more between the halves is not a lag
inline constexpr double kHeldIntervals =
    1.5;  ///< intervals between samples: smaller lags come from how commands are held

/// Columns for accelerations that a wrong model of the joint may cause: the model's own without commands, constant,
/// linear in position and velocity, and direction of motion; rows over the accelerations' noise.
Eigen::MatrixXd surroundings(const ChannelAccelerations& channel);

/// How well a trial's accelerations follow earlier commands, by lag.
struct CommandLagProfile {
  std::size_t trial = 0;
  double rows = 0.0;            ///< accelerations
  double freedom = 0.0;         ///< number of rows less the number of fitted coefficients
  double power = 0.0;           ///< sum of squares of the accelerations, in noise variances
  double of_model = 0.0;        ///< sum of squares of the residual of the model's own accelerations, in noise variances
  Eigen::VectorXd early, late;  ///< the same from the first and the second half of the rows alone
  /// By lag: squares that surroundings and lagged commands leave unexplained, in noise variances.
  Eigen::VectorXd squares;
};

struct CommandLags {
  Eigen::VectorXd lags;                     ///< s, positive where the motion follows the command
  double interval = 0.0;                    ///< s, longest time between samples of the trials
  std::vector<CommandLagProfile> profiles;  ///< of the trials with commands, force actuators and enough rows
};

/// Each trial has its own coefficients, so that a common fault of all trials cannot look like a lag of one.
CommandLags command_lags(const DataCheckTask& task, const AccelerationTable& table);

/// The lag with the smallest residual over all of `profiles`; an index into the lags.
Eigen::Index best_lag(const std::vector<const CommandLagProfile*>& profiles);

/// Best lag of the second halves minus that of the first, s: shows a clock that runs fast or slow, not a constant
/// shift.
double lag_drift(const CommandLags& lags, const std::vector<const CommandLagProfile*>& profiles);

}  // namespace lacuna
