#include "prediction/start_prior.h"

#include <Eigen/Cholesky>

#include <limits>

namespace lacuna {

StartPrior prior_of(const Eigen::MatrixXd& covariance) {
  StartPrior prior;
  prior.deviation = covariance.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt();
  const Eigen::VectorXd inverse = prior.deviation.cwiseInverse();
  Eigen::MatrixXd correlation = inverse.asDiagonal() * covariance * inverse.asDiagonal();
  correlation.diagonal().array() += 1e-9;
  prior.precision = correlation.ldlt().solve(Eigen::MatrixXd::Identity(correlation.rows(), correlation.cols()));
  return prior;
}

}  // namespace lacuna
