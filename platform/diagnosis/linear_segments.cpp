#include "diagnosis/linear_segments.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

std::vector<LinearSegment> linear_segments(ShootingProblem& problem, const RowBins& bins, const FitPoint& point,
                                           const std::vector<Eigen::VectorXd>& residuals) {
  std::vector<SegmentJacobian> jacobians;
  problem.linearize_finely(point, residuals, jacobians);
  std::vector<LinearSegment> segments;
  for (std::size_t k = 0; k < residuals.size(); ++k)
    segments.push_back({bins.means(k, residuals[k]), bins.means(k, jacobians[k].values),
                        bins.means(k, jacobians[k].state) * problem.segments()[k].deviation.asDiagonal()});
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
