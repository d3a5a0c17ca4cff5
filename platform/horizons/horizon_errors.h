#pragma once

#include "horizons/ladder.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// A model's errors over the rungs of a ladder, and what they cost.
struct HorizonErrors {
  bool valid = false;
  std::vector<std::vector<double>> mean_square;  ///< by rung and channel: residuals, winsorised; channel unit squared
  std::vector<std::vector<double>> weight;       ///< by rung and channel; 0: does not count. All sum to 1
  double cost = 0.0;                             ///< Σ weight·ρ, nats: half the log of a mean squared error
};

/// The cost of a mean square m where a right model leaves `floor`: ½ ln m above it, the Gaussian likelihood of a known
/// variance below. Both meet with one slope.
double cost_of(double mean_square, double floor);

/// `residuals`: a vector a segment, rung by rung, measured minus predicted in channel units; rows beyond a segment's
/// are not looked at.
HorizonErrors horizon_errors(const Ladder& ladder, const std::vector<Trial>& trials,
                             const std::vector<Eigen::VectorXd>& residuals);

}  // namespace lacuna
