#pragma once

#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// A number of the model that a recording may have separately: of the robot or of a placed effect.
struct PossibleValue {
  FreeValue value;         ///< as if free in all recordings
  double lower, upper;     ///< that are possible
  bool is_bounded = true;  ///< whether bounds for a fit are given
};

/// All of them, the robot's first. The effects must be placed.
std::vector<PossibleValue> possible_values(const ModelDefinition& definition);

/// SI, of the first match of an address or a pattern such as `body.*.mass`; empty: none.
std::string unit_of_value(const ModelDefinition& definition, const std::string& pattern);

}  // namespace lacuna
