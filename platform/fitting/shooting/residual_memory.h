#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <vector>

namespace lacuna {

/// How residuals of a stage hang together in time.
struct ResidualMemory {
  double time = 0.0;               ///< the longest correlation time over trials and channels, s
  double effective_samples = 1.0;  ///< samples over those that vary together, summed over trials and channels
};

/// From residuals (a vector a segment; rows of priors do not count), each trial and channel in the order of time.
ResidualMemory residual_memory(const ShootingProblem& problem, const std::vector<Eigen::VectorXd>& residuals);

}  // namespace lacuna
