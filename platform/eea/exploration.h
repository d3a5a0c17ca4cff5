#pragma once

#include "eea/eea_run.h"

namespace lacuna {

/// Step 4 of the seed: evolves, from random ones, a test that the test fitness likes best, judged by the best models.
/// Leaves it in `state.next_test`. A test fitness that looks at no model likes every test the same: a random one.
void explore(const EeaRun& run, EeaState& state);

/// The test of step 1b, or one that stands in for a test that the target could not carry out (`attempt` > 0).
void choose_random_test(const EeaRun& run, EeaState& state, int attempt);

}  // namespace lacuna
