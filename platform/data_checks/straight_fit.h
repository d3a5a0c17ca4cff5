#pragma once

#include <Eigen/Core>

namespace lacuna {

/// Linear least squares, rows in units of their noise.
struct StraightFit {
  Eigen::VectorXd coefficients;
  Eigen::VectorXd deviations;  ///< standard deviations, from the larger of the noise and the residual
  double squares = 0.0;        ///< of the residual
};

/// Columns that depend linearly on others get a coefficient of zero and an infinite deviation.
StraightFit straight_fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values);

}  // namespace lacuna
