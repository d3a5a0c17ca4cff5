#pragma once

#include "answer/diagnosis.h"
#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// A sentence on each of the model's own values that rests on a bound, or whose 95 % interval a bound cuts short: which
/// bound, and what to do. Nothing on a lower bound of 0, below which most values mean nothing. `values`: by the
/// addresses of `free`.
std::vector<std::string> bound_findings(const std::vector<FreeValue>& free, const std::vector<FoundParameter>& values);

}  // namespace lacuna
