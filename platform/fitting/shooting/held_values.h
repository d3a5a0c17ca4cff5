#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <vector>

namespace lacuna {

/// The coordinates of all values where those that are `free` fit best and the others stay where they are; as they were
/// where the model cannot be simulated there. Start states are fitted with them, under the problem's scales.
Eigen::VectorXd fit_beside_held(ShootingProblem& problem, const Eigen::VectorXd& values,
                                const std::vector<Eigen::Index>& free, const LeastSquaresOptions& options);

}  // namespace lacuna
