#pragma once

#include "horizons/ladder.h"

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// A model's errors over the rungs of a ladder, and what they cost.
struct HorizonErrors {
  bool valid = false;
  std::vector<std::vector<double>> mean_square;  ///< by rung and channel: residuals, winsorised; channel unit squared
  std::vector<std::vector<double>> weight;       ///< by rung and channel: the ladder's, of what was read; sum to 1
  double cost = 0.0;                             ///< Σ weight·ρ, nats: half the log of a mean squared error
};

/// The cost of a mean square m where a right model leaves `floor`: ½ ln m above it, the Gaussian likelihood of a known
/// variance below. Both meet with one slope.
double cost_of(double mean_square, double floor);

double slope_of_cost(double mean_square, double floor);  ///< d cost_of / d mean_square

/// `residuals`: a vector a segment, rung by rung, measured minus predicted in channel units; rows beyond a segment's
/// are not looked at.
HorizonErrors horizon_errors(const Ladder& ladder, const std::vector<Trial>& trials,
                             const std::vector<Eigen::VectorXd>& residuals);

/// Weights that fall with how few independent errors a rung and channel has: times min(1, n/8), where n = 2 m²/Var(m)
/// with the variance of means of segments. From the residuals of the model as it is, for all models alike.
void weigh_by_information(Ladder& ladder, const std::vector<Trial>& trials,
                          const std::vector<Eigen::VectorXd>& residuals);

}  // namespace lacuna
