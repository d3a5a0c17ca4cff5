#pragma once

#include "fitting/shooting_problem.h"
#include "horizons/horizon_errors.h"

#include <vector>

namespace lacuna {

/// Values fitted to a ladder.
struct HorizonFit {
  std::vector<double> values;  ///< of the model
  HorizonErrors errors;
  int iterations = 0;  ///< linearisations
  std::uint64_t simulations = 0;
};

/// Finds the values under which the ladder's cost is least, from `start`: least squares with the weights that the
/// cost's slope gives, again and again until it no longer falls (the cost is concave in the mean squares, so that each
/// round descends). Starts of the longest rung are refitted within their uncertainty.
HorizonFit fit_to_ladder(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                         const std::vector<double>& start);

/// The errors with values as they are, starts as the data tell them.
HorizonErrors errors_on(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                        const std::vector<double>& values);

}  // namespace lacuna
