#include "diagnosis/noise/linear_segments.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kFurthest = 1e5;

}  // namespace

Eigen::MatrixXd bounded_responses(const Eigen::MatrixXd& state) {
  if (state.norm() <= kFurthest) return state;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(state, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return svd.matrixU() * svd.singularValues().cwiseMin(kFurthest).asDiagonal() * svd.matrixV().transpose();
}

std::vector<LinearSegment> linear_segments(ShootingProblem& problem, const RowBins& bins, const FitPoint& point,
                                           const std::vector<Eigen::VectorXd>& residuals) {
  std::vector<SegmentJacobian> jacobians;
  problem.linearize_finely(point, residuals, jacobians);
  std::vector<LinearSegment> segments;
  for (std::size_t k = 0; k < residuals.size(); ++k)
    segments.push_back(
        {bins.means(k, residuals[k]), bins.means(k, jacobians[k].values),
         bounded_responses(bins.means(k, jacobians[k].state) * problem.segments()[k].deviation.asDiagonal())});
  return segments;
}

double rms(const std::vector<LinearSegment>& segments) {
  double squares = 0.0, count = 0.0;
  for (const LinearSegment& segment : segments) {
    squares += segment.residual.squaredNorm();
    count += static_cast<double>(segment.residual.size());
  }
  return std::sqrt(squares / std::max(count, 1.0));
}

}  // namespace lacuna
