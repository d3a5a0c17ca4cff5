#pragma once

#include "app/workspace/open_experiment.h"
#include "fitting/substeps.h"

#include <string>
#include <vector>

namespace lacuna {

/// Decides how many integration steps the rig's model takes, where its experiment leaves that open: as many as free
/// runs of these trials need and, where values are fitted to them, as keep these values' bias small. Nothing changes
/// where that was decided before. Returns what the user is told, a sentence: what was found, or that what the file says
/// is far more than is needed; empty: nothing. Throws `Interrupted`.
std::string settle_substeps(OpenExperiment& opened, const std::vector<Trial>& trials, const Work& work,
                            TrialsFor trials_for = TrialsFor::fit);

}  // namespace lacuna
