#pragma once

#include "app/runs/run_plan.h"

namespace lacuna {

/// Runs the algorithm as `lacuna run` does: begins or goes on, shows progress, prints what was found. Throws
/// `BadInput`, `Interrupted` where it can be gone on with, `Error` where a replicate failed.
void carry_out_run(const RunOptions& options);

}  // namespace lacuna
