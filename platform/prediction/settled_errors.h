#pragma once

#include "prediction/linear_prediction.h"

#include <optional>

namespace lacuna {

/// Residuals of a model with these values, by cell of the ladder: mean squares of whitened residuals, so that 1 is the
/// level of reading noise and unknown initial states for a right model. The initial states move to the smallest
/// residual; the values stay. 0 where a cell has no readings; nothing where a stretch cannot be simulated. `values`:
/// coordinates.
std::optional<Eigen::VectorXd> settled_errors(LadderPredictions& predictions, const Eigen::VectorXd& values);

}  // namespace lacuna
