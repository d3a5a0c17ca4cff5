#include "diagnosis/noise/whitened.h"

#include <lacuna/error.h>

#include <Eigen/QR>

namespace lacuna {

WhitenedSegments::WhitenedSegments(const NoiseModel& noise, const std::vector<LinearSegment>& segments) {
  std::vector<Eigen::MatrixXd> residuals, values;
  first_.push_back(0);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Eigen::MatrixXd covariance;
    noise.lower_covariance(k, covariance);
    dense::add_square(1.0, segments[k].state, covariance);
    const dense::Cholesky factor(std::move(covariance));
    if (!factor.exists())
      throw Error("the covariance of the noise is not positive definite; is a channel without any noise?");
    factors_.push_back(factor.lower());
    first_.push_back(first_.back() + segments[k].residual.size());
    residuals.emplace_back(segments[k].residual);
    values.push_back(segments[k].values);
  }
  const Eigen::MatrixXd white = whiten(values);
  if (white.cols() > 0) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(white);
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(white.rows(), qr.rank());
  } else {
    basis_.resize(white.rows(), 0);
  }
  residual_ = project(residuals);
}

Eigen::MatrixXd WhitenedSegments::whiten(const std::vector<Eigen::MatrixXd>& columns) const {
  Eigen::MatrixXd all(rows(), columns.front().cols());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    auto rows = all.middleRows(first_[k], columns[k].rows());
    rows = columns[k];
    dense::solve_lower(factors_[k], rows);
  }
  return all;
}

Eigen::MatrixXd WhitenedSegments::beside_values(Eigen::MatrixXd white) const {
  dense::add_product(-1.0, basis_, dense::product(basis_.transpose(), white), white);
  return white;
}

}  // namespace lacuna
