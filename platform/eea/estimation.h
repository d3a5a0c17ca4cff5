#pragma once

#include "eea/eea_run.h"

namespace lacuna {

/// Step 3 of the seed: evolves models that explain all trials so far, from random ones and, where the experiment says
/// so, the best of the pass before. Leaves the best models in `state.best`.
void estimate(const EeaRun& run, EeaState& state);

}  // namespace lacuna
