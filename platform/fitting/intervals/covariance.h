#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <string>
#include <vector>

namespace lacuna {

/// Uncertainty of fitted values, in coordinates of the parameter space.
struct Uncertainty {
  Eigen::MatrixXd covariance;  ///< NaN where a value is at a bound or not determined
  /// Of the weighted least squares; 0 for values at a bound and along directions that are not determined.
  Eigen::MatrixXd inverse_information;
  std::vector<bool> determined;   ///< per value; a value at a bound counts as determined
  double quantile = 0.0;          ///< of Student's t: half an interval is quantile × standard error
  double correlation_time = 0.0;  ///< of the residual, s
  int blocks = 0;
  bool few_blocks = false;   ///< the record is too short for blocks much longer than the correlation time
  double enough_data = 0.0;  ///< s, duration of a record that is not
  std::vector<Eigen::VectorXd> undetermined;  ///< directions of relative change that do not change the prediction
  Eigen::VectorXd sizes;  ///< the change that a relative change of 1 means for each value, in coordinates
};

/// Covariance of the shared values with the initial states eliminated. Residuals are correlated in time where the model
/// is imperfect, so the scores are summed over blocks several correlation times long before they are squared (the
/// cluster-robust "sandwich"; H. White, 1982; A. C. Cameron and D. L. Miller, "A practitioner's guide to cluster-robust
/// inference", 2015), with G/(G − p) and Student's t of G − p degrees of freedom for G blocks and p values. Directions
/// whose relative standard error exceeds `kUndetermined` are reported and left out. `at_bound`: values held at a bound,
/// which get no uncertainty.
Uncertainty uncertainty(const ShootingProblem& problem, const ParameterSpace& space, const FitPoint& point,
                        const std::vector<Eigen::VectorXd>& residuals, const std::vector<SegmentJacobian>& jacobians,
                        const RobustLoss& loss, const std::vector<bool>& at_bound);

inline constexpr double kUndetermined = 0.5;

}  // namespace lacuna
