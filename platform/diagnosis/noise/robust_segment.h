#pragma once

#include "fitting/robust_loss.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lacuna {

/// The loss of a whitened bin, in all fits and judgements: beyond four standard deviations it counts linearly.
inline constexpr RobustLoss kBinLoss{4.0};

/// A segment as a fit sees it, to first order: whitened rows, those of bins first, then those of priors, which count by
/// their squares.
struct RobustSegment {
  Eigen::VectorXd residual;
  Eigen::MatrixXd values;             ///< its derivatives by the values' coordinates
  Eigen::MatrixXd state;              ///< and by what is unknown of the start
  std::vector<std::size_t> block_of;  ///< of each bin: the number of its block within the segment, 0 on
  Eigen::Index priors_of_values = 0;  ///< last rows, which do not depend on the start

  Eigen::Index bins() const { return static_cast<Eigen::Index>(block_of.size()); }
  std::size_t blocks() const { return *std::max_element(block_of.begin(), block_of.end()) + 1; }
  /// Of each row, where the residual is `residual`.
  Eigen::VectorXd weights(const Eigen::VectorXd& residual) const;
};

/// A segment under weights that are held, with what its own start could explain taken out.
struct WeightedSegment {
  Eigen::VectorXd residual;
  Eigen::MatrixXd values;
  Eigen::MatrixXd start_follows;  ///< derivatives of the start that fits best by the values
};

WeightedSegment weighted(const RobustSegment& segment, const Eigen::VectorXd& weights);

/// `residual` after the start has moved to where the loss is least.
Eigen::VectorXd at_best_start(const RobustSegment& segment, Eigen::VectorXd residual);

/// −2 log likelihood, but for a constant, of each block of a segment whose residual at some start is `residual`; the
/// start is free, and what it costs counts with the first block. What is known of the values beforehand is no
/// reading, and counts nowhere.
Eigen::VectorXd block_deviances(const RobustSegment& segment, const Eigen::VectorXd& residual);

}  // namespace lacuna
