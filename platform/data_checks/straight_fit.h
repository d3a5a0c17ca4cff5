#pragma once

#include <Eigen/Core>

namespace lacuna {

/// Linear least squares, rows in units of their noise.
struct StraightFit {
  Eigen::VectorXd coefficients;
  Eigen::VectorXd deviations;  ///< standard deviations, from the larger of the noise and the residual
  double squares = 0.0;        ///< of the residual
};

/// Of columns that depend linearly on each other the coefficients are the smallest that fit (of columns scaled to one
/// length), and their deviations infinite; a column of zeros gets a coefficient of zero.
StraightFit straight_fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values);

}  // namespace lacuna
