#pragma once

#include <Eigen/Core>

namespace lacuna {

/// P⁻¹ in coordinates that are one standard deviation each, with what they are divided by.
struct StartPrior {
  Eigen::VectorXd deviation;
  Eigen::MatrixXd precision;  ///< of start over deviation
};

/// `covariance`: of the unknown components of a start, SI. Its correlation gets 1e-9 more on the diagonal.
StartPrior prior_of(const Eigen::MatrixXd& covariance);

}  // namespace lacuna
