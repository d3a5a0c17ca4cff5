#pragma once

#include "where_it_fails/state_features.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// What accelerates a channel and is not in the model. A prediction's error adds up what the model lacked before; its
/// second derivative (of a velocity's error the first) is what it lacks now, but for what a wrong state does to the
/// model's own forces, which in first order is linear in the error and its derivative.
struct UnexplainedAcceleration {
  Channel channel;             ///< its unit is that of the acceleration
  Eigen::VectorXd values;      ///< a row of the feature table; NaN where there is too little around it
  Eigen::VectorXd deviations;  ///< of their noise
  Eigen::MatrixXd own_error;   ///< the error and, of a position, its derivative: what the wrong state explains
};

/// Of every position and velocity channel of the fit trials, by parabolas (of a velocity, lines) through the residual:
/// through 100 ms of it where that shows three times its noise, else through 200 or 400 ms, and always nine samples.
/// The residuals are those of free runs where these stay within a tenth of the motion, so that the linear share of the
/// wrong state is all there is; else those of predictions restarted from the data, the longest that there are.
struct Accelerations {
  double horizon = 0.0;  ///< s, after which predictions were restarted; 0: free runs
  std::vector<UnexplainedAcceleration> channels;
};
Accelerations unexplained_accelerations(const RobotSpec& robot, const Comparison& comparison,
                                        const FeatureTable& table);

}  // namespace lacuna
