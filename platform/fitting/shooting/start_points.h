#pragma once

#include "evaluation/model/model_definition.h"
#include "fitting/shooting/shooting_problem.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// Starting points of a fit, in coordinates of the space: first the model's values; then, if any of them is zero,
/// points with finite sizes there, because an effect may have no gradient at zero; then random points within the
/// bounds. A value's size does not follow from its bounds, which may be orders of magnitude away, but from the data:
/// the change that moves the prediction by as much as the current residual, or by half of its largest possible change.
/// `count` points, at least one.
std::vector<Eigen::VectorXd> start_points(ShootingProblem& problem, const ParameterSpace& space,
                                          const std::vector<FreeValue>& free, int count, std::uint64_t seed);

}  // namespace lacuna
