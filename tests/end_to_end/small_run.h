#pragma once

#include "support/small_experiment.h"

namespace lacuna {

/// A second or two on one thread.
inline const std::string kSmallRun = small_experiment("1.0", "population = 40, keep = 20, generations = 8",
                                                      "population = 10, keep = 5, generations = 5");

}  // namespace lacuna
