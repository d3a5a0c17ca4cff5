#include "experiment_design/rival_refit.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace lacuna {

Eigen::VectorXd unexplained(const RivalPrediction& truth, const RivalPrediction& rival, double trials) {
  const Eigen::VectorXd difference = truth.readings - rival.readings;
  const Eigen::MatrixXd& follows = rival.follows;
  const Eigen::Index rows = difference.size(), refitted = follows.cols();
  Eigen::MatrixXd normal = trials * (follows.transpose() * follows);
  normal.diagonal().array() += 1.0;
  const Eigen::VectorXd moved = rival.moved.size() > 0 ? rival.moved : Eigen::VectorXd::Zero(refitted);
  const Eigen::VectorXd step = normal.ldlt().solve(trials * (follows.transpose() * difference) - moved);
  Eigen::VectorXd left(rows + refitted);
  left.head(rows) = std::sqrt(trials) * (difference - follows * step);
  left.tail(refitted) = moved + step;
  return left;
}

}  // namespace lacuna
