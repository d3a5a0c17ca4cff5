#include "experiment_design/candidate_refit.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace lacuna {

Eigen::VectorXd unexplained(const CandidatePrediction& truth, const CandidatePrediction& candidate, double trials) {
  const Eigen::VectorXd difference = truth.readings - candidate.readings;
  const Eigen::MatrixXd& follows = candidate.follows;
  const Eigen::Index rows = difference.size(), refitted = follows.cols();
  Eigen::MatrixXd normal = trials * (follows.transpose() * follows);
  normal.diagonal().array() += 1.0;
  const Eigen::VectorXd moved = candidate.moved.size() > 0 ? candidate.moved : Eigen::VectorXd::Zero(refitted);
  const Eigen::VectorXd step = normal.ldlt().solve(trials * (follows.transpose() * difference) - moved);
  Eigen::VectorXd left(rows + refitted);
  left.head(rows) = std::sqrt(trials) * (difference - follows * step);
  left.tail(refitted) = moved + step;
  return left;
}

}  // namespace lacuna
