#pragma once

#include "fitting/starts/start_fit.h"

#include <span>
#include <vector>

namespace lacuna {

/// A part of a run with its own initial state, which its first samples determine.
struct RunPiece {
  Stretch stretch;
  StartEstimate start;
  Eigen::Index first_scored = 0;  ///< sample of the trial from which on the run is this piece's
};

/// A model's prediction of a whole trial from the initial state that the trial's first samples determine, or, where
/// runs of the trial restart after a while (restarts.h), from those of its pieces. The first samples of later pieces
/// are predicted by the piece before.
struct FreeRun {
  StartEstimate start;            ///< of the first piece
  Eigen::Index first_scored = 0;  ///< sample
  std::vector<RunPiece> pieces;
  Prediction prediction;
};

/// `values`: the model's. Thread-safe for different workers.
FreeRun free_run(const TrialPredictor& predictor, const StartStates& states, std::size_t trial,
                 std::span<const double> values, int worker);

/// A run in the same pieces, with their initial states, by another predictor of the same trials.
Prediction predict_again(const TrialPredictor& predictor, std::size_t trial, const std::vector<RunPiece>& pieces,
                         std::span<const double> values, int worker);

/// RMS over the scored time of the change of the run's prediction by one standard error of the initial state; one per
/// channel.
Eigen::VectorXd effect_of_start(const TrialPredictor& predictor, std::size_t trial, std::span<const double> values,
                                const FreeRun& run, int worker);

}  // namespace lacuna
