#pragma once

#include "eea/eea_run.h"

#include <string>

namespace lacuna {

/// Records how well the best model predicted a new trial; counts passes without improvement. Restarts the count where
/// more of each trial counts than before.
void note_surprise(const EeaRun& run, EeaState& state, double surprise);

/// Why another test would be of no use, a sentence: predictions of new trials have not improved for the experiment's
/// `patience`. Empty: it may be of use.
std::string lost_patience(const EeaRun& run, const EeaState& state);

/// Why the test that was found is of no use, a sentence: its worth is below the experiment's `stop_below`. Empty: it
/// may be of use.
std::string too_little_to_learn(const EeaRun& run, const EeaState& state);

}  // namespace lacuna
