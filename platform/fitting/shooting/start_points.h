#pragma once

#include "evaluation/model/model_definition.h"
#include "fitting/shooting/shooting_problem.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// Where a fit starts from, in coordinates of the space: first the model's own values; then, if the model
/// starts any of its values at zero, points with finite sizes there, because an effect may have no gradient at
/// zero; then points drawn within the bounds. A value's size is not read off its bounds, which may be
/// orders of magnitude away, but off the data: the change that moves the prediction by as much as the
/// residual now is, or by half of the most it can. `count` points, at least one.
std::vector<Eigen::VectorXd> start_points(ShootingProblem& problem, const ParameterSpace& space,
                                          const std::vector<FreeValue>& free, int count, std::uint64_t seed);

}  // namespace lacuna
