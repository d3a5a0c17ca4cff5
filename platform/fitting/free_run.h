#pragma once

#include "fitting/head_fit.h"

#include <span>

namespace lacuna {

/// A model's prediction of a whole trial from the start that the trial's head tells.
struct FreeRun {
  StartEstimate start;
  Eigen::Index first_scored = 0;  ///< sample
  Prediction prediction;
};

/// `values`: the model's. Thread-safe for different workers.
FreeRun free_run(const TrialPredictor& predictor, const StartStates& states, std::size_t trial,
                 std::span<const double> values, int worker);

/// RMS over the scored time of what one standard error of the start does to the run's prediction; one a channel.
Eigen::VectorXd effect_of_start(const TrialPredictor& predictor, std::size_t trial, std::span<const double> values,
                                const FreeRun& run, int worker);

}  // namespace lacuna
