#pragma once

#include "app/runs/open_eea_run.h"

#include <string>

namespace lacuna {

/// What `lacuna check` says of an experiment's target, tests and searches.
std::string run_summary(const OpenEeaRun& opened);

}  // namespace lacuna
