#pragma once

#include "diagnosis/rounds/cut_trials.h"
#include "fitting/start_states.h"

namespace lacuna {

/// For robots whose state cannot be told from their sensors (bodies that float, joints that nothing measures): each
/// trial is simulated in one run from its known start, and what it predicts is judged in blocks of about `task.segment`
/// s, each of which begins at the trial's start and is compared with its own stretch of time alone. A run ends before
/// the first block in which the prediction is no longer one: where shorter steps and slightly other contacts
/// (contact_doubt.h) change it by more than a third of what the sensors do. Fills segments, bin widths and remarks of
/// `base`, whose trials and noise are known.
void cut_free_runs(const CutTask& task, const TrialPredictor& predictor, const StartStates& states, BaseSolution& base);

}  // namespace lacuna
