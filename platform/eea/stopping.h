#pragma once

#include "eea/eea_run.h"

#include <string>

namespace lacuna {

/// Notes how well the best model foretold a new trial; passes in which that gets no better are counted.
void note_surprise(EeaState& state, double surprise);

/// Why there is no use in another pass, a sentence: no test makes the models differ by more than the experiment's
/// `stop_below`, or they have not foretold a trial any better for its `patience`. Empty: there is.
std::string reason_to_stop(const EeaRun& run, const EeaState& state);

}  // namespace lacuna
