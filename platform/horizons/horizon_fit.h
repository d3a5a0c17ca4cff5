#pragma once

#include "fitting/shooting_problem.h"
#include "horizons/horizon_errors.h"

#include <vector>

namespace lacuna {

/// Values fitted to a ladder.
struct HorizonFit {
  std::vector<double> values;              ///< of the model
  std::vector<Eigen::VectorXd> states;     ///< by segment: its start, where that is refitted
  std::vector<Eigen::VectorXd> residuals;  ///< by segment, measured minus predicted, channel units
  HorizonErrors errors;
  double prior_weight = 0.0;  ///< of a squared departure of a start in standard deviations, beside the cost
  int iterations = 0;         ///< linearisations
  std::uint64_t simulations = 0;
};

/// How a fit climbs.
enum class Climb {
  from_the_bottom,  ///< from far off: the shortest rung first, whose predictions lead to the longer ones
  whole             ///< all rungs at once, from values that are nearly right
};

/// Finds the values under which the ladder's cost is least, from `start`: of each linearisation the least cost within
/// bounds is gone to, or a part of the way, until little is left to gain. Starts of the longest rung are refitted
/// within their uncertainty.
HorizonFit fit_to_ladder(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                         const std::vector<double>& start, Climb climb = Climb::from_the_bottom);

/// A fit that was made before: with values, and starts where they were refitted, as they are.
HorizonFit fit_at(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                  const std::vector<double>& values, const std::vector<Eigen::VectorXd>& states = {});

/// The errors with values as they are, starts as the data tell them.
HorizonErrors errors_on(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                        const std::vector<double>& values);

}  // namespace lacuna
