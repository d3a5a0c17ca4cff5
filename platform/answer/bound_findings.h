#pragma once

#include "answer/diagnosis.h"
#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// A sentence on each value of the robot or model that lies on a bound, or whose 95 % interval a bound cuts short:
/// which bound, and what to do. No sentence on a lower bound of 0, because most quantities cannot be negative. `values`
/// have the addresses of `free`.
std::vector<std::string> bound_findings(const std::vector<FreeValue>& free, const std::vector<FoundParameter>& values);

}  // namespace lacuna
