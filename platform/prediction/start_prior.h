#pragma once

#include <Eigen/Core>

namespace lacuna {

/// P⁻¹ in coordinates scaled to one standard deviation each, with the scale factors.
struct StartPrior {
  Eigen::VectorXd deviation;
  Eigen::MatrixXd precision;  ///< start over deviation
};

/// `covariance`: of the unknown components of a start, SI. Adds 1e-9 to the diagonal of its correlation matrix.
StartPrior prior_of(const Eigen::MatrixXd& covariance);

}  // namespace lacuna
