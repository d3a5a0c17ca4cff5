#include "diagnosis/refit/jackknife.h"

namespace lacuna {

Eigen::MatrixXd wary_covariance(const Refit& fit, const Folds& folds) {
  const std::vector<Eigen::VectorXd> steps = steps_without(fit, folds);
  const auto count = static_cast<double>(steps.size());
  if (steps.size() < 2) return fit.covariance;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(fit.covariance.rows()), squares = mean;
  for (const Eigen::VectorXd& step : steps) mean += step / count;
  for (const Eigen::VectorXd& step : steps) squares += (step - mean).cwiseAbs2();
  const Eigen::VectorXd variance = (count - 1.0) / count * squares, own = fit.covariance.diagonal();
  const Eigen::VectorXd wider =
      (own.array() > 0.0).select(variance.array() / own.array().max(1e-300), 1.0).cwiseMax(1.0).sqrt();
  return wider.asDiagonal() * fit.covariance * wider.asDiagonal();
}

}  // namespace lacuna
