#pragma once

#include "evaluation/model/model_definition.h"

#include <string>

namespace lacuna {

/// A sentence where an effect of the model (`id` of its entry) only changes values of the robot that are free in the
/// model, as viscous friction does beside a free damping of its joint: data cannot distinguish the two. Empty: the
/// effect has another influence, or none of it is free.
std::string redundancy_of(const ModelDefinition& model, const std::string& id);

}  // namespace lacuna
