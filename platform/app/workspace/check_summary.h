#pragma once

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"
#include "measurement/recording.h"

#include <string>
#include <vector>

namespace lacuna {

/// What an accepted experiment says and what was read for it, a few lines: robot, free values, effects; trials with
/// samples, seconds and rate; each channel with its column and the range of its values in SI units, where a wrong
/// unit or sign is seen; notes of the reading.
std::string check_summary(const Experiment& experiment, const ModelDefinition& definition,
                          const std::vector<Trial>& trials, const std::vector<ReadingNote>& notes);

}  // namespace lacuna
