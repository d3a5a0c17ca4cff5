#include "diagnosis/refit/whitened_problem.h"

#include "diagnosis/refit/timing.h"

#include <lacuna/error.h>

#include <cmath>

namespace lacuna {

WhitenedProblem::WhitenedProblem(ShootingProblem& problem, const RowBins& bins,
                                 const std::vector<Eigen::MatrixXd>& factors, Timing timing)
    : problem_(problem),
      bins_(bins),
      factors_(factors),
      timing_(timing),
      timing_root_(1.0 / std::sqrt(kTimingVariance * static_cast<double>(factors.size()))) {}

Eigen::MatrixXd WhitenedProblem::whitened(std::size_t k, const Eigen::MatrixXd& rows) const {
  const Eigen::Index measured = problem_.robust_rows(k), priors = rows.rows() - measured;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(bins_.rows(k) + priors + priors_of_values(), rows.cols());
  result.topRows(bins_.rows(k)) = bins_.means(k, rows);
  dense::solve_lower(factors_[k], result.topRows(bins_.rows(k)));
  result.middleRows(bins_.rows(k), priors) = rows.bottomRows(priors);
  return result;
}

bool WhitenedProblem::simulate(const FitPoint& point) {
  if (!raw_.empty() && point.values == simulated_.values && point.states == simulated_.states) return true;
  std::vector<Eigen::VectorXd> raw;
  if (!problem_.residuals(point, raw)) return false;
  raw_ = std::move(raw);
  simulated_ = point;
  return true;
}

bool WhitenedProblem::residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) {
  if (!simulate(point)) return false;
  residuals.resize(raw_.size());
  for (std::size_t k = 0; k < raw_.size(); ++k) {
    residuals[k] = whitened(k, raw_[k]);
    residuals[k].tail(priors_of_values()) = timing_root_ * point.values.tail(priors_of_values());
  }
  return true;
}

void WhitenedProblem::linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>&,
                                std::vector<SegmentJacobian>& jacobians) {
  if (!simulate(point)) throw Error("a point that was simulated before cannot be simulated again");
  std::vector<SegmentJacobian> unwhitened;
  problem_.linearize(simulated_, raw_, unwhitened);
  jacobians.resize(raw_.size());
  for (std::size_t k = 0; k < raw_.size(); ++k) {
    jacobians[k].values = whitened(k, unwhitened[k].values);
    jacobians[k].values.bottomRightCorner(priors_of_values(), priors_of_values()).setConstant(timing_root_);
    jacobians[k].state = whitened(k, unwhitened[k].state);
  }
}

std::vector<Eigen::MatrixXd> noise_factors(const NoiseModel& noise) {
  std::vector<Eigen::MatrixXd> factors;
  for (std::size_t k = 0; k < noise.segments(); ++k) {
    const dense::Cholesky factor = factor_of([&](Eigen::MatrixXd& sum) { noise.lower_covariance(k, sum); });
    if (!factor.exists())
      throw Error("the covariance of the noise is not positive definite; is a channel without any noise?");
    factors.push_back(factor.triangle());
  }
  return factors;
}

}  // namespace lacuna
