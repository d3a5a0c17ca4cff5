#pragma once

#include "evaluation/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// The fixed value of the robot file that `add wrong_value` names. Throws `BadInput` where the options do not name one
/// of the robot.
EffectEntry asked_value(const std::vector<std::string>& where, const std::string& id,
                        const std::vector<std::string>& fixed, const ModelDefinition& base);

}  // namespace lacuna
