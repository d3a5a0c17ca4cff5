#include "diagnosis/whitened.h"

#include <lacuna/error.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace lacuna {

WhitenedSegments::WhitenedSegments(const NoiseModel& noise, const std::vector<LinearSegment>& segments) {
  std::vector<Eigen::MatrixXd> residuals, values;
  first_.push_back(0);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Eigen::LLT<Eigen::MatrixXd> factor(noise.covariance(k) + segments[k].state * segments[k].state.transpose());
    if (factor.info() != Eigen::Success)
      throw Error("the covariance of the noise is not positive definite; is a channel without any noise?");
    factors_.emplace_back(factor.matrixL());
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
  for (std::size_t k = 0; k < columns.size(); ++k)
    all.middleRows(first_[k], columns[k].rows()) = factors_[k].triangularView<Eigen::Lower>().solve(columns[k]);
  return all;
}

Eigen::MatrixXd WhitenedSegments::project(const std::vector<Eigen::MatrixXd>& columns) const {
  Eigen::MatrixXd all = whiten(columns);
  all -= basis_ * (basis_.transpose() * all);
  return all;
}

}  // namespace lacuna
