#pragma once

#include <Eigen/Core>

namespace hidden_effects {

/// Log odds = intercept + weights · row.
struct LogisticFit {
  double intercept = 0.0;
  Eigen::VectorXd weights;
};

double logistic(double log_odds);

/// Maximum of the likelihood of `right` (0 or 1, one a row) less half of `penalty` times the squared length of the
/// weights, each in standard deviations of its column: few cases move a weight little. The intercept, at the columns'
/// means, is held by half a right and half a wrong case (H. Jeffreys' prior), so that it is finite where all are right.
LogisticFit fit_logistic(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right, double penalty = 1.0);

/// The same with the sign of each weight known, 1 or −1: one that would be otherwise is zero.
LogisticFit fit_logistic(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right, double penalty,
                         const Eigen::VectorXd& signs);

}  // namespace hidden_effects
