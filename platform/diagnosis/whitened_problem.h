#pragma once

#include "diagnosis/noise_model.h"

#include <vector>

namespace lacuna {

/// A shooting problem whose measured rows are thinned and whitened by the covariance of all noise, so that its cost is
/// twice the negative log likelihood, but for a constant; rows of priors stay as they are. After the model's values
/// come the coefficients of the nuisance columns.
class WhitenedProblem : public SegmentedProblem {
 public:
  /// `factors`: by segment, the lower Cholesky factor of the bins' covariance; `nuisance`: see BaseSolution. All must
  /// outlive the problem.
  WhitenedProblem(ShootingProblem& problem, const RowBins& bins, const std::vector<Eigen::MatrixXd>& factors,
                  const std::vector<Eigen::MatrixXd>& nuisance);

  const Eigen::VectorXd& lower() const override { return lower_; }
  const Eigen::VectorXd& upper() const override { return upper_; }
  Eigen::Index nuisances() const { return nuisance_.empty() ? 0 : nuisance_.front().cols(); }
  Eigen::Index robust_rows(std::size_t k) const override { return bins_.rows(k); }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override;
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override;

 private:
  /// Measured rows become whitened bins; the others follow.
  Eigen::MatrixXd whitened(std::size_t k, const Eigen::MatrixXd& rows) const;
  /// The point of the model alone.
  FitPoint of_model(const FitPoint& point) const;
  /// Brings `raw_` to that point. False where it cannot be simulated.
  bool simulate(const FitPoint& point);

  ShootingProblem& problem_;
  std::vector<Eigen::VectorXd> raw_;  ///< residuals of the model at the last point that could be simulated,
  FitPoint simulated_;                ///< which most often is linearised next
  const RowBins& bins_;
  const std::vector<Eigen::MatrixXd>& factors_;
  std::vector<Eigen::MatrixXd> nuisance_;  ///< whitened
  Eigen::VectorXd lower_, upper_;
};

/// Lower Cholesky factors of the noise alone, a segment each.
std::vector<Eigen::MatrixXd> noise_factors(const NoiseModel& noise);

}  // namespace lacuna
