#include "fitting/shooting/reduced_rows.h"

#include <Eigen/Cholesky>

namespace lacuna {
namespace {

ReducedRows reduce_segment(const SegmentedProblem& problem, std::size_t k, const Eigen::VectorXd& residuals,
                           const SegmentJacobian& jacobian, const RobustLoss& loss) {
  ReducedRows rows;
  rows.curvature = Eigen::VectorXd::Ones(residuals.size());
  rows.score = residuals;
  for (Eigen::Index row = 0; row < problem.robust_rows(k); ++row) {
    rows.curvature(row) = loss.curvature(residuals(row));
    rows.score(row) = loss.weight(residuals(row)) * residuals(row);
  }
  rows.sensitivity = jacobian.values;
  if (jacobian.state.cols() == 0) return rows;
  const Eigen::MatrixXd weighted = rows.curvature.asDiagonal() * jacobian.state;
  const Eigen::MatrixXd normal = weighted.transpose() * jacobian.state;
  rows.sensitivity -= jacobian.state * normal.ldlt().solve(weighted.transpose() * jacobian.values);
  return rows;
}

}  // namespace

std::vector<ReducedRows> reduce(const SegmentedProblem& problem, const std::vector<Eigen::VectorXd>& residuals,
                                const std::vector<SegmentJacobian>& jacobians, const RobustLoss& loss) {
  std::vector<ReducedRows> rows;
  for (std::size_t k = 0; k < residuals.size(); ++k)
    rows.push_back(reduce_segment(problem, k, residuals[k], jacobians[k], loss));
  return rows;
}

Eigen::MatrixXd information(const std::vector<ReducedRows>& rows) {
  const Eigen::Index size = rows.front().sensitivity.cols();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (const ReducedRows& segment : rows)
    sum += segment.sensitivity.transpose() * segment.curvature.asDiagonal() * segment.sensitivity;
  return sum;
}

}  // namespace lacuna
