#include "fitting/step_shift.h"

#include "fitting/reduced_rows.h"

namespace lacuna {
namespace {

constexpr double kToNoStep = 2.0;  ///< halves of a first-order error: 1/2 + 1/4 + ... of the whole, over its first

}  // namespace

std::optional<Eigen::VectorXd> step_shift(const ShootingProblem& problem, const TrialPredictor& finer,
                                          const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                          const std::vector<SegmentJacobian>& jacobians, const RobustLoss& loss,
                                          const Uncertainty& known) {
  ShootingProblem with_half_steps(problem, finer);
  std::vector<Eigen::VectorXd> finer_residuals;
  if (!with_half_steps.residuals(point, finer_residuals)) return std::nullopt;
  const std::vector<ReducedRows> rows = reduce(problem, residuals, jacobians, loss);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(known.inverse_information.rows());
  for (std::size_t k = 0; k < rows.size(); ++k)
    gradient += rows[k].sensitivity.transpose() * rows[k].curvature.cwiseProduct(finer_residuals[k] - residuals[k]);
  return Eigen::VectorXd(-kToNoStep * known.inverse_information * gradient);
}

}  // namespace lacuna
