#include "data_checks/straight_fit.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {

StraightFit straight_fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values) {
  constexpr double kSpanned = 1e-10;  // smallest eigenvalue of the correlation matrix over the largest
  const Eigen::Index count = columns.cols();
  Eigen::VectorXd norms = columns.colwise().norm();
  for (double& norm : norms)
    if (!(norm > 0.0)) norm = 1.0;
  const Eigen::MatrixXd unit = columns * norms.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(unit.transpose() * unit);
  const double least = kSpanned * eigen.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::VectorXd mixed = eigen.eigenvectors().transpose() * (unit.transpose() * values);
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(count), variances = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double value = eigen.eigenvalues()(i);
    const Eigen::VectorXd direction = eigen.eigenvectors().col(i);
    if (value > least) {
      solution += direction * (mixed(i) / value);
      variances += direction.cwiseAbs2() / value;
    } else {
      for (Eigen::Index j = 0; j < count; ++j)
        if (std::abs(direction(j)) > 1e-6) variances(j) = std::numeric_limits<double>::infinity();
    }
  }
  StraightFit fit;
  fit.squares = (values - unit * solution).squaredNorm();
  const double freedom = std::max(static_cast<double>(values.size() - count), 1.0);
  const double scale = std::sqrt(std::max(fit.squares / freedom, 1.0));
  fit.coefficients = solution.cwiseQuotient(norms);
  fit.deviations = scale * variances.cwiseSqrt().cwiseQuotient(norms);
  return fit;
}

}  // namespace lacuna
