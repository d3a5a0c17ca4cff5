#pragma once

#include "fitting/covariance.h"

#include <optional>

namespace lacuna {

/// By how much the best values, in coordinates of the parameter space, would move if the model were integrated in
/// infinitely short steps: the engine is of first order, so twice what half the steps move them by. `finer` simulates
/// with half the steps. One Gauss–Newton step from the solution: a simulation a segment, no new derivatives. 0 for
/// values at a bound and along directions that the data do not determine; nothing where `finer` cannot simulate the
/// solution. `residuals`, `jacobians` and `known` are those of `problem` at `point`.
///
/// Literature: L. F. Richardson, "The deferred approach to the limit", 1927.
std::optional<Eigen::VectorXd> step_shift(const ShootingProblem& problem, const TrialPredictor& finer,
                                          const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                          const std::vector<SegmentJacobian>& jacobians, const RobustLoss& loss,
                                          const Uncertainty& known);

}  // namespace lacuna
