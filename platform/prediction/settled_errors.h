#pragma once

#include "prediction/linear_prediction.h"

#include <optional>

namespace lacuna {

/// What a model with these values leaves, by cell of the ladder: mean squares of whitened residuals, so that 1 is what
/// reading noise and unknown starts leave of a right model. Starts move to where they leave least; values stay. 0 where
/// a cell has no readings; nothing where a stretch cannot be simulated. `values`: coordinates.
std::optional<Eigen::VectorXd> settled_errors(LadderPredictions& predictions, const Eigen::VectorXd& values);

}  // namespace lacuna
