#include "criterion/value_errors.h"

#include "criterion/evidence.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kConcerned = 0.01;  ///< of an untold direction, from which on a value is not told

/// Half the gradient of the cost by values, block by block in columns.
Eigen::MatrixXd gradients(const CellLayout& layout, const BlockProducts& products, const LinearCost& fit) {
  const Eigen::Index n = products.values();
  const Eigen::VectorXd weights = square_weights(layout, products, fit.mean_square);
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(layout.blocks()));
  for (std::size_t c = 0; c < layout.cells.size(); ++c)
    for (std::size_t b = 0; b < layout.blocks(); ++b) {
      const BlockProducts::ConstProduct product = products.at(c, b);
      all.col(static_cast<Eigen::Index>(b)) +=
          weights(static_cast<Eigen::Index>(c)) * (product.col(0).tail(n) - product.bottomRightCorner(n, n) * fit.step);
    }
  return all;
}

/// Σ over groups of so many blocks of their gradient's square, as if there were many groups.
Eigen::MatrixXd scatter(const Eigen::MatrixXd& gradients, Eigen::Index together) {
  const Eigen::Index groups = (gradients.cols() + together - 1) / together;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(gradients.rows(), gradients.rows());
  for (Eigen::Index i = 0; i < groups; ++i) {
    const Eigen::Index size = std::min(together, gradients.cols() - i * together);
    const Eigen::VectorXd group = gradients.middleCols(i * together, size).rowwise().sum();
    sum += group * group.transpose();
  }
  const double freedom = std::max(1.0, static_cast<double>(groups - gradients.rows()));
  return sum * static_cast<double>(groups) / freedom;
}

}  // namespace

ValueErrors value_errors(const CellLayout& layout, const BlockProducts& products, const LinearCost& fit,
                         const Eigen::VectorXd& ridge) {
  const Eigen::Index n = products.values();
  ValueErrors errors{Eigen::MatrixXd::Zero(n, n), std::vector<bool>(static_cast<std::size_t>(n), true)};
  if (n == 0) return errors;
  Eigen::MatrixXd known = information(layout, products, fit);
  if (ridge.size() == n) known.diagonal() += ridge.cwiseProduct(Eigen::VectorXd(known.diagonal()));
  const Eigen::VectorXd scale = known.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * known * scale.asDiagonal());
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::VectorXd direction = eigen.eigenvectors().col(i);
    if (eigen.eigenvalues()(i) > kUntold * eigen.eigenvalues().maxCoeff())
      inverse += direction * direction.transpose() / eigen.eigenvalues()(i);
    else
      for (Eigen::Index j = 0; j < n; ++j)
        if (direction(j) * direction(j) > kConcerned) errors.is_told[static_cast<std::size_t>(j)] = false;
  }
  inverse = scale.asDiagonal() * inverse * scale.asDiagonal();
  const Eigen::MatrixXd by_block = gradients(layout, products, fit);
  for (const Eigen::Index together : kBlocksTogether) {
    const Eigen::MatrixXd covariance = inverse * scatter(by_block, together) * inverse;
    const Eigen::VectorXd more =
        (covariance.diagonal().cwiseMax(1e-300).cwiseQuotient(errors.covariance.diagonal().cwiseMax(1e-300)))
            .cwiseMax(1.0)
            .cwiseSqrt();
    if (together == kBlocksTogether.front())
      errors.covariance = covariance;
    else
      errors.covariance = more.asDiagonal() * errors.covariance * more.asDiagonal();
  }
  return errors;
}

}  // namespace lacuna
