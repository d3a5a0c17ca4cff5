#pragma once

#include "data_checks/doubt.h"

#include <string>
#include <vector>

namespace lacuna {

/// What speaks against these data, the faults first. A few simulations of the fit trials,
/// none of them fitted; nothing is random. Recordings of a rig that lacks an effect are no reason for doubt: each test
/// allows for an inertia, stiffness, damping, dry friction and offset that differ from the model's. Throws `Error`
/// where the trials do not fit the model.
std::vector<Doubt> data_doubts(const DoubtTask& task);

/// The sentences of those that make figures wrong.
std::vector<std::string> faults_among(const std::vector<Doubt>& doubts);

/// The sentences of those that limit what the recordings can tell, and make no figure wrong.
std::vector<std::string> limits_among(const std::vector<Doubt>& doubts);

}  // namespace lacuna
