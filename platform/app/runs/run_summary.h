#pragma once

#include "app/runs/eea_bench.h"

#include <string>

namespace lacuna {

/// What `lacuna check` says of an experiment's target, tests and searches.
std::string run_summary(const EeaBench& bench);

}  // namespace lacuna
