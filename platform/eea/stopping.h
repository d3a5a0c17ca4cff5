#pragma once

#include "eea/eea_run.h"

#include <string>

namespace lacuna {

/// Notes how well the best model foretold a new trial; passes in which that gets no better are counted. Where more of
/// each trial counts than before, counting begins anew.
void note_surprise(const EeaRun& run, EeaState& state, double surprise);

/// Why there is no use in looking for another test, a sentence: models have not foretold a trial any better for the
/// experiment's `patience`. Empty: there is.
std::string lost_patience(const EeaRun& run, const EeaState& state);

/// Why there is no use in the test that was found, a sentence: it is worth less than the experiment's `stop_below`.
/// Empty: there is.
std::string too_little_to_learn(const EeaRun& run, const EeaState& state);

}  // namespace lacuna
