#pragma once

#include "config/schema/experiment.h"

#include <string>
#include <vector>

namespace lacuna {

/// Reads `key=a,b,c`. A comma within brackets, braces or quotes parts nothing. Throws `Error` where there is no key or
/// no value.
SweptKey read_sweep(const std::string& text);

/// Every combination of the values, the last key's changing fastest, as settings that `--set` takes; one empty
/// combination where there are no keys.
std::vector<std::vector<std::string>> sweep_points(const std::vector<SweptKey>& keys);

}  // namespace lacuna
