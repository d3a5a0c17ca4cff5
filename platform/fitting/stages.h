#pragma once

#include "fitting/fit.h"
#include "fitting/starts/start_states.h"

#include <string>
#include <vector>

namespace lacuna {

/// One planned round of a fit.
struct PlannedStage {
  std::string name;
  double length = 0.0;     ///< s; 0: whole trials
  bool automatic = false;  ///< the length is found when the stage begins
};

/// The stages that the options ask for and the data allow; decisions go to `notes`. Throws `Error` for a method or
/// horizon that does not exist.
std::vector<PlannedStage> plan_stages(const FitSection& options, const TrialPredictor& predictor,
                                      const StartStates& states, std::vector<std::string>& notes);

inline constexpr double kTolerableGrowth = 2.0;

/// The longest horizon over which the uncertainty of an initial state, estimated on `head` s, moves no channel by more
/// than `growth` times its noise, or, where the model does not follow even these samples, its misfit there (one
/// standard deviation); the median over starts throughout the trials. Infinite: no limit.
double automatic_horizon(const TrialPredictor& predictor, const StartStates& states, const std::vector<double>& values,
                         double head, double growth = kTolerableGrowth);

}  // namespace lacuna
