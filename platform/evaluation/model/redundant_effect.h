#pragma once

#include "evaluation/model/model_definition.h"

#include <string>

namespace lacuna {

/// A sentence where an effect of the model (`id` of its entry) does nothing but change values of the robot that the
/// model leaves free, as viscous friction does with a free damping of its joint: no data tell the two apart. Empty:
/// it does something of its own, or nothing of it is free.
std::string redundancy_of(const ModelDefinition& model, const std::string& id);

}  // namespace lacuna
