#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <vector>

namespace lacuna {

/// The coordinates of all values where the `free` ones fit best and the others stay; unchanged where the model cannot
/// be simulated there. Initial states are fitted with them, with the problem's scales.
Eigen::VectorXd fit_beside_held(ShootingProblem& problem, const Eigen::VectorXd& values,
                                const std::vector<Eigen::Index>& free, const LeastSquaresOptions& options);

}  // namespace lacuna
