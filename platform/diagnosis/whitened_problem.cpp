#include "diagnosis/whitened_problem.h"

#include <lacuna/error.h>

#include <Eigen/Cholesky>

namespace lacuna {
WhitenedProblem::WhitenedProblem(ShootingProblem& problem, const RowBins& bins,
                                 const std::vector<Eigen::MatrixXd>& factors,
                                 const std::vector<Eigen::MatrixXd>& nuisance)
    : problem_(problem), bins_(bins), factors_(factors) {
  for (std::size_t k = 0; k < nuisance.size(); ++k)
    nuisance_.emplace_back(factors_[k].triangularView<Eigen::Lower>().solve(nuisance[k]));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(nuisances());
  lower_.resize(problem_.lower().size() + ones.size());
  upper_.resize(lower_.size());
  lower_ << problem_.lower(), -ones;
  upper_ << problem_.upper(), ones;
}

FitPoint WhitenedProblem::of_model(const FitPoint& point) const {
  return {point.values.head(problem_.lower().size()), point.states};
}

Eigen::MatrixXd WhitenedProblem::whitened(std::size_t k, const Eigen::MatrixXd& rows) const {
  const Eigen::Index measured = problem_.robust_rows(k), priors = rows.rows() - measured;
  Eigen::MatrixXd result(bins_.rows(k) + priors, rows.cols());
  result.topRows(bins_.rows(k)) = factors_[k].triangularView<Eigen::Lower>().solve(bins_.means(k, rows));
  result.bottomRows(priors) = rows.bottomRows(priors);
  return result;
}

bool WhitenedProblem::simulate(const FitPoint& point) {
  FitPoint model = of_model(point);
  if (!raw_.empty() && model.values == simulated_.values && model.states == simulated_.states) return true;
  std::vector<Eigen::VectorXd> raw;
  if (!problem_.residuals(model, raw)) return false;
  raw_ = std::move(raw);
  simulated_ = std::move(model);
  return true;
}

bool WhitenedProblem::residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) {
  if (!simulate(point)) return false;
  residuals.resize(raw_.size());
  for (std::size_t k = 0; k < raw_.size(); ++k) {
    residuals[k] = whitened(k, raw_[k]);
    if (nuisances() > 0) residuals[k].head(bins_.rows(k)) += nuisance_[k] * point.values.tail(nuisances());
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
    const Eigen::MatrixXd values = whitened(k, unwhitened[k].values);
    jacobians[k].values = Eigen::MatrixXd::Zero(values.rows(), values.cols() + nuisances());
    jacobians[k].values.leftCols(values.cols()) = values;
    if (nuisances() > 0) jacobians[k].values.topRightCorner(bins_.rows(k), nuisances()) = nuisance_[k];
    jacobians[k].state = whitened(k, unwhitened[k].state);
  }
}

std::vector<Eigen::MatrixXd> noise_factors(const NoiseModel& noise) {
  std::vector<Eigen::MatrixXd> factors;
  for (std::size_t k = 0; k < noise.segments(); ++k) {
    const Eigen::LLT<Eigen::MatrixXd> factor = factor_of(noise.covariance(k));
    if (factor.info() != Eigen::Success)
      throw Error("the covariance of the noise is not positive definite; is a channel without any noise?");
    factors.emplace_back(factor.matrixL());
  }
  return factors;
}

}  // namespace lacuna
