#pragma once

#include "config/schema/experiment.h"
#include "measurement/recording.h"

#include <vector>

namespace lacuna {

/// Controllers of `target.controllers` that do not make the recorded commands (data_checks/wrong_controllers.h): a
/// sentence on each at its place in the file, with the trials that show it.
std::vector<ReadingNote> controller_notes(const Experiment& experiment, const std::vector<Trial>& trials);

}  // namespace lacuna
