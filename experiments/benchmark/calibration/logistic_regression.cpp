#include "calibration/logistic_regression.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace hidden_effects {
namespace {

constexpr int kMostSteps = 100;
constexpr double kConverged = 1e-9;
constexpr double kPriorCases = 0.5;  ///< of either kind
constexpr double kConstant = 1e-9;   ///< a column that scatters by less tells nothing

struct Standardised {
  Eigen::RowVectorXd mean, scale;
  Eigen::MatrixXd rows;  ///< with a first column of ones
};

Standardised standardised(const Eigen::MatrixXd& rows) {
  Standardised to;
  const double count = static_cast<double>(rows.rows());
  to.mean = rows.colwise().sum() / count;
  to.scale = ((rows.rowwise() - to.mean).colwise().squaredNorm() / count).cwiseSqrt();
  to.rows = Eigen::MatrixXd::Ones(rows.rows(), rows.cols() + 1);
  for (Eigen::Index j = 0; j < rows.cols(); ++j) {
    if (to.scale(j) > kConstant)
      to.rows.col(j + 1) = (rows.col(j).array() - to.mean(j)) / to.scale(j);
    else
      to.rows.col(j + 1).setZero();
  }
  return to;
}

}  // namespace

double logistic(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

LogisticFit fit_logistic(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right, double penalty) {
  const Standardised data = standardised(rows);
  Eigen::VectorXd penalties = Eigen::VectorXd::Constant(rows.cols() + 1, penalty);
  penalties(0) = 0.0;
  Eigen::VectorXd at = Eigen::VectorXd::Zero(rows.cols() + 1);
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::VectorXd p = (data.rows * at).unaryExpr(&logistic);
    Eigen::MatrixXd curvature =
        data.rows.transpose() * (p.array() * (1.0 - p.array())).matrix().asDiagonal() * data.rows;
    curvature.diagonal() += penalties;
    Eigen::VectorXd slope = data.rows.transpose() * (right - p) - penalties.cwiseProduct(at);
    const double middle = logistic(at(0));
    slope(0) += kPriorCases * (1.0 - 2.0 * middle);
    curvature(0, 0) += 2.0 * kPriorCases * middle * (1.0 - middle);
    const Eigen::VectorXd move = curvature.ldlt().solve(slope);
    at += move;
    if (move.norm() < kConverged) break;
  }
  LogisticFit fit{at(0), Eigen::VectorXd::Zero(rows.cols())};
  for (Eigen::Index j = 0; j < rows.cols(); ++j)
    if (data.scale(j) > kConstant) fit.weights(j) = at(j + 1) / data.scale(j);
  fit.intercept -= fit.weights.dot(data.mean.transpose());
  return fit;
}

LogisticFit fit_logistic(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right, double penalty,
                         const Eigen::VectorXd& signs) {
  Eigen::MatrixXd kept = rows;
  for (Eigen::Index round = 0; round <= rows.cols(); ++round) {
    LogisticFit fit = fit_logistic(kept, right, penalty);
    const Eigen::VectorXd scales =
        ((kept.rowwise() - kept.colwise().mean()).colwise().squaredNorm() / static_cast<double>(kept.rows()))
            .cwiseSqrt();
    const Eigen::VectorXd along = fit.weights.cwiseProduct(signs).cwiseProduct(scales);
    Eigen::Index worst = 0;
    if (along.size() == 0 || along.minCoeff(&worst) >= 0.0) return fit;
    kept.col(worst).setZero();
  }
  return fit_logistic(kept, right, penalty);
}

}  // namespace hidden_effects
