#include "measurement/series/blocked_regression.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kBelowZero = -0.05;  ///< of a target's variance: the most by which the explained part may exceed it
constexpr double kRidge = 1e-10;      ///< of a regressor's own product: similar regressors share their influence

}  // namespace

BlockedRegression::BlockedRegression(Eigen::Index regressors, Eigen::Index targets, std::size_t blocks)
    : regressors_(regressors),
      products_(blocks, Eigen::MatrixXd::Zero(regressors + targets, regressors + targets)),
      total_(Eigen::MatrixXd::Zero(regressors + targets, regressors + targets)) {}

void BlockedRegression::add(std::size_t block, const Eigen::VectorXd& row, const Eigen::VectorXd& again) {
  // Plain loops: Eigen's products of such short vectors cost more, and a hundred times more in a debug build.
  const Eigen::Index n = row.size();
  double* of_block = products_[block].data();
  double* of_all = total_.data();
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i) {
      const double product = 0.5 * (row.data()[i] * again.data()[j] + again.data()[i] * row.data()[j]);
      of_block[j * n + i] += product;
      of_all[j * n + i] += product;
    }
}

double BlockedRegression::variance(Eigen::Index target) const {
  const Eigen::Index t = regressors_ + target;
  const double mean = total_(0, t) / rows();
  return total_(t, t) / rows() - mean * mean;
}

std::optional<Eigen::VectorXd> BlockedRegression::coefficients(const Eigen::MatrixXd& products,
                                                               Eigen::Index target) const {
  Eigen::MatrixXd normal = products.topLeftCorner(regressors_, regressors_);
  normal.diagonal() *= 1.0 + kRidge;
  const auto factors = normal.ldlt();
  if (!(factors.vectorD().minCoeff() > 0.0)) return std::nullopt;
  return factors.solve(products.col(regressors_ + target).head(regressors_));
}

double BlockedRegression::unexplained_of(const Eigen::MatrixXd& products, Eigen::Index target) const {
  const Eigen::Index t = regressors_ + target;
  const double rows = products(0, 0);
  const double varies = products(t, t) - products(0, t) * products(0, t) / rows;
  if (!(rows > static_cast<double>(2 * regressors_)) || !(varies > 0.0)) return std::nan("");
  const auto fitted = coefficients(products, target);
  if (!fitted) return std::nan("");
  const double share = (products(t, t) - fitted->dot(products.col(t).head(regressors_))) / varies;
  return share > kBelowZero ? share : std::nan("");
}

std::vector<double> BlockedRegression::errors(Eigen::Index target) const {
  const Eigen::Index t = regressors_ + target;
  const auto fitted = coefficients(total_, target);
  std::vector<double> errors;
  if (!fitted) return errors;
  for (const Eigen::MatrixXd& products : products_) {
    const double squares = products(t, t) - 2.0 * fitted->dot(products.col(t).head(regressors_)) +
                           fitted->dot(products.topLeftCorner(regressors_, regressors_) * *fitted);
    errors.push_back(products(0, 0) > 0.0 ? squares / products(0, 0) : std::nan(""));
  }
  return errors;
}

}  // namespace lacuna
