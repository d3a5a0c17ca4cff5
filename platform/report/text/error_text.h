#pragma once

#include "fitting/comparison.h"

#include <string>

namespace lacuna {

/// The error over all trials of a side: "1.20 mrad", or "2 trials failed" where it is not known because of these.
std::string error_text(const PooledScore& score);

}  // namespace lacuna
