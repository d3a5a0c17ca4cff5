#pragma once

#include "eea/eea_run.h"

#include <vector>

namespace lacuna {

/// Managed challenge (J. Bongard, H. Lipson: tests that are too hard for the present models are set aside and come
/// back): keeps a trial that no present model can explain from spoiling their progress.

/// Surprise of a trial that has just been carried out: score of the best model so far on as much of it as of the trials
/// that it was fitted to. Not known where there is no model or it cannot be simulated.
double surprise_of(const EeaRun& run, EeaState& state, const TargetTrial& trial);

/// Sets the newest trial aside where its surprise exceeds the experiment's `challenge` times the best model's score on
/// its fit trials. The first trials are never set aside.
void set_aside_if_too_hard(const EeaRun& run, EeaState& state, double surprise);

/// After an estimation phase: trials that the new best model explains well enough, or that have waited long enough,
/// count again from the next pass on.
void recall_trials(const EeaRun& run, EeaState& state);

}  // namespace lacuna
