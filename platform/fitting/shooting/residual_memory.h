#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <vector>

namespace lacuna {

/// Correlation in time of the residuals of a stage.
struct ResidualMemory {
  double time = 0.0;  ///< the longest correlation time over trials and channels, s
  /// Number of samples over the number that vary together, summed over trials and channels.
  double effective_samples = 1.0;
};

/// From residuals (a vector a segment; rows of priors do not count), each trial and channel in the order of time.
ResidualMemory residual_memory(const ShootingProblem& problem, const std::vector<Eigen::VectorXd>& residuals);

}  // namespace lacuna
