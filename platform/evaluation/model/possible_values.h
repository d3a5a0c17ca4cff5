#pragma once

#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// A number of the model that a recording may have for itself: one of the robot or of a placed effect.
struct PossibleValue {
  FreeValue value;         ///< as it is free in all recordings, or would be
  double lower, upper;     ///< that are possible
  bool is_bounded = true;  ///< whether somebody says where to look for it
};

/// All of them, the robot's first. The effects must be placed.
std::vector<PossibleValue> possible_values(const ModelDefinition& definition);

/// SI, of the first one that an address or a pattern such as `body.*.mass` means; empty: none.
std::string unit_of_value(const ModelDefinition& definition, const std::string& pattern);

}  // namespace lacuna
