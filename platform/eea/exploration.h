#pragma once

#include "eea/eea_run.h"

namespace lacuna {

/// Step 4 of the seed: evolves, from random ones, a test with the largest test fitness, judged by the best models.
/// Leaves it in `state.next_test`. A test fitness that uses no model gives every test the same value: the result is a
/// random test.
void explore(const EeaRun& run, EeaState& state);

/// The test of step 1b, or a replacement for a test that the target could not carry out (`attempt` > 0).
void choose_random_test(const EeaRun& run, EeaState& state, int attempt);

}  // namespace lacuna
