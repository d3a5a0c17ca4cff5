#pragma once

#include "diagnosis/noise/noise_model.h"

#include <vector>

namespace lacuna {

/// All segments below each other, the noise whitened, and what the start states and the model's values could take up
/// projected out: what is left is standard normal where the model is right.
class WhitenedSegments {
 public:
  WhitenedSegments(const NoiseModel& noise, const std::vector<LinearSegment>& segments);

  const Eigen::VectorXd& residual() const { return residual_; }
  /// `columns`: by segment, bins × any number. Columns below each other, whitened, projected.
  Eigen::MatrixXd project(const std::vector<Eigen::MatrixXd>& columns) const { return beside_values(whiten(columns)); }
  /// The same without the projection of the model's values.
  Eigen::MatrixXd whiten(const std::vector<Eigen::MatrixXd>& columns) const;
  /// Whitened columns, projected.
  Eigen::MatrixXd beside_values(Eigen::MatrixXd white) const;
  /// Where segment `k` begins.
  Eigen::Index first(std::size_t k) const { return first_[k]; }
  Eigen::Index rows() const { return first_.back(); }

 private:
  std::vector<Eigen::MatrixXd> factors_;  ///< lower Cholesky factors of noise and start together
  std::vector<Eigen::Index> first_;
  Eigen::MatrixXd basis_;  ///< orthonormal, of the model's values
  Eigen::VectorXd residual_;
};

}  // namespace lacuna
