#pragma once

#include "config/experiment.h"
#include "evaluation/model_definition.h"
#include "measurement/recording.h"

#include <string>

namespace lacuna {

/// A few lines on what an accepted experiment says: robot, free values, effects, trials.
std::string check_summary(const Experiment& experiment, const ModelDefinition& definition, const Recording& recording);

}  // namespace lacuna
