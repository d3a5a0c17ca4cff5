#pragma once

#include "fitting/starts/head_fit.h"

#include <span>
#include <vector>

namespace lacuna {

/// A part of a run with a start of its own, which its head tells.
struct RunPiece {
  Stretch stretch;
  StartEstimate start;
  Eigen::Index first_scored = 0;  ///< sample of the trial; from here on the run is this piece's
};

/// A model's prediction of a whole trial from the start that the trial's head tells, or, where runs of the trial start
/// anew after a while (restarts.h), from those of its pieces. Heads behind the first are predicted by the piece before.
struct FreeRun {
  StartEstimate start;            ///< of the first piece
  Eigen::Index first_scored = 0;  ///< sample
  std::vector<RunPiece> pieces;
  Prediction prediction;
};

/// `values`: the model's. Thread-safe for different workers.
FreeRun free_run(const TrialPredictor& predictor, const StartStates& states, std::size_t trial,
                 std::span<const double> values, int worker);

/// A run in the same pieces, with their starts, by another predictor of the same trials.
Prediction predict_again(const TrialPredictor& predictor, std::size_t trial, const std::vector<RunPiece>& pieces,
                         std::span<const double> values, int worker);

/// RMS over the scored time of what one standard error of the start does to the run's prediction; one a channel.
Eigen::VectorXd effect_of_start(const TrialPredictor& predictor, std::size_t trial, std::span<const double> values,
                                const FreeRun& run, int worker);

}  // namespace lacuna
