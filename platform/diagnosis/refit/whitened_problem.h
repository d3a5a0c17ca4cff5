#pragma once

#include "diagnosis/noise/noise_model.h"

#include <vector>

namespace lacuna {

/// A shooting problem whose measured rows are thinned and whitened by the covariance of all noise, so that its cost is
/// twice the negative log likelihood, but for a constant; rows of priors stay as they are, and where timing is
/// fitted, the last value, each segment has its share of what is known of it beforehand (timing.h) as a row of priors.
class WhitenedProblem : public SegmentedProblem {
 public:
  /// `factors`: by segment, the lower Cholesky factor of the bins' covariance. They must outlive the problem.
  WhitenedProblem(ShootingProblem& problem, const RowBins& bins, const std::vector<Eigen::MatrixXd>& factors,
                  Timing timing);

  const Eigen::VectorXd& lower() const override { return problem_.lower(); }
  const Eigen::VectorXd& upper() const override { return problem_.upper(); }
  Eigen::Index robust_rows(std::size_t k) const override { return bins_.rows(k); }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override;
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override;
  /// The last values of which something is known beforehand, and the last rows of each segment, which say it: the
  /// timing's, or none.
  Eigen::Index priors_of_values() const { return timing_ == Timing::fitted ? 1 : 0; }

 private:
  /// Measured rows become whitened bins; the others follow, and the timing's, which is zero.
  Eigen::MatrixXd whitened(std::size_t k, const Eigen::MatrixXd& rows) const;
  /// Brings `raw_` to that point. False where it cannot be simulated.
  bool simulate(const FitPoint& point);

  ShootingProblem& problem_;
  std::vector<Eigen::VectorXd> raw_;  ///< residuals before whitening at the last point that could be simulated,
  FitPoint simulated_;                ///< which most often is linearised next
  const RowBins& bins_;
  const std::vector<Eigen::MatrixXd>& factors_;
  Timing timing_;
  double timing_root_ = 0.0;  ///< of a segment's share of the information on timing
};

/// Lower Cholesky factors of the noise alone, a segment each.
std::vector<Eigen::MatrixXd> noise_factors(const NoiseModel& noise);

}  // namespace lacuna
