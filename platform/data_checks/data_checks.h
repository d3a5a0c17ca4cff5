#pragma once

#include "data_checks/data_warning.h"

#include <string>
#include <vector>

namespace lacuna {

/// The findings of the data checks, faults first. Makes a few simulations of the fit trials, no fits and no random
/// draws. An effect that the model lacks is not a fault of the data: each check allows for an inertia, stiffness,
/// damping, dry friction and offset that differ from the model's. Throws `Error` where the trials do not fit the model.
std::vector<DataWarning> data_checks(const DataCheckTask& task);

/// The sentences of the faults, which make results wrong.
std::vector<std::string> faults_among(const std::vector<DataWarning>& doubts);

/// The sentences of the notes, which limit what the recordings can show but make no result wrong.
std::vector<std::string> limits_among(const std::vector<DataWarning>& doubts);

}  // namespace lacuna
