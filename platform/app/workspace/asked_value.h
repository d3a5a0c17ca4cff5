#pragma once

#include "evaluation/model/model_definition.h"

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// The fixed value of the robot file that `add wrong_value` names. Throws `BadInput` where the options do not name one
/// of the robot, or a start of another name.
EffectEntry asked_value(const std::vector<std::string>& where, const std::string& id,
                        const std::vector<std::string>& fixed, const std::map<std::string, double>& start,
                        const ModelDefinition& base);

}  // namespace lacuna
