#pragma once

#include "evaluation/model/model_definition.h"

#include <map>
#include <string>
#include <utility>

namespace lacuna {

/// For each free parameter of an effect that has a start value in `entry`: bounds that hold everything up to ten times
/// as large (on a logarithmic scale from a tenth on), within its declared ones. A search draws from the whole range of
/// a value, and what an effect allows says nothing of the robot at hand. Bounds that would not become narrower, and
/// those of a value that starts at 0, are left out. In SI, to four digits.
std::map<std::string, std::pair<double, double>> search_range(const EffectEntry& entry,
                                                              const ModelDefinition& extended);

}  // namespace lacuna
