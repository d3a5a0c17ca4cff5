#pragma once

#include "where_it_fails/state_features.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// Acceleration of a channel that the model lacks. The error of a prediction accumulates what the model lacked before;
/// its second derivative (for a velocity the first) is what it lacks now, apart from the change of the model's own
/// forces with its wrong state, which to first order is linear in the error and its derivative.
struct UnexplainedAcceleration {
  Channel channel;             ///< its unit is that of the acceleration
  Eigen::VectorXd values;      ///< one per row of the feature table; NaN where there are too few samples around it
  Eigen::VectorXd deviations;  ///< of their noise
  Eigen::MatrixXd own_error;   ///< the error and, for a position, its derivative: covariates for the wrong state
};

/// For every position and velocity channel of the fit trials, by parabolas (for a velocity, lines) through the
/// residual: through 100 ms of it where that exceeds three times its noise, else through 200 or 400 ms, and always at
/// least nine samples. The residuals are those of free runs where these stay within a tenth of the motion, so that the
/// influence of the wrong state is linear; else those of the longest predictions restarted from the data.
struct Accelerations {
  double horizon = 0.0;  ///< s, after which predictions were restarted; 0: free runs
  std::vector<UnexplainedAcceleration> channels;
};
Accelerations unexplained_accelerations(const RobotSpec& robot, const Comparison& comparison,
                                        const FeatureTable& table);

}  // namespace lacuna
