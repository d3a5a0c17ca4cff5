#pragma once

#include "config/schema/experiment.h"

#include <string>
#include <vector>

namespace lacuna {

/// What the program decides where an experiment leaves it open, noted in `Experiment::decided`. What a file or --set
/// says stays.
void decide_engine(Experiment& experiment, const std::string& engine);
void decide_substeps(Experiment& experiment, int substeps);
/// Whether that was done to the number of substeps.
bool substeps_decided(const Experiment& experiment);

/// The same decisions once more, of an experiment that was stored with them. Throws `BadInput` where they are none.
void decide_as(Experiment& experiment, const std::vector<std::string>& decided);

}  // namespace lacuna
