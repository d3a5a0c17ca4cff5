#pragma once

#include "data_checks/acceleration_table.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

inline constexpr double kSteadyLag = 0.5;      ///< of a lag: by more from half to half, and it is none
inline constexpr double kHeldIntervals = 1.5;  ///< between samples: a lag less than that is how samples are held

/// Columns of accelerations that no model of the joint is doubted for: the model's own without commands, and what is
/// constant, linear in position and velocity, or follows the direction of motion; rows over the accelerations' noise.
Eigen::MatrixXd surroundings(const ChannelAccelerations& channel);

/// How well a trial's accelerations follow its commands of some time before.
struct CommandLagProfile {
  std::size_t trial = 0;
  double rows = 0.0;            ///< accelerations
  double freedom = 0.0;         ///< rows less the coefficients fitted
  double power = 0.0;           ///< squares of the accelerations, in noise variances
  double of_model = 0.0;        ///< squares that the model's own accelerations leave, in noise variances
  Eigen::VectorXd early, late;  ///< the same of the first and the second half of the rows alone
  Eigen::VectorXd squares;      ///< by lag: what is left beside surroundings and lagged commands, in noise variances
};

struct CommandLags {
  Eigen::VectorXd lags;                     ///< s, positive where the motion follows the command
  double interval = 0.0;                    ///< s, between samples, the longest of the trials
  std::vector<CommandLagProfile> profiles;  ///< of the trials that are commanded, have force actuators and enough rows
};

/// Every trial with coefficients of its own, so that what is in common to trials cannot pass for a lag of one.
CommandLags command_lags(const DoubtTask& task, const AccelerationTable& table);

/// The lag that leaves least in all of `profiles`; an index into the lags.
Eigen::Index best_lag(const std::vector<const CommandLagProfile*>& profiles);

/// Best lag of the later halves minus that of the earlier ones, s: a clock that gains shows, a shifted one does not.
double lag_drift(const CommandLags& lags, const std::vector<const CommandLagProfile*>& profiles);

}  // namespace lacuna
