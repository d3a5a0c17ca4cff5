#pragma once

#include "app/runs/open_eea_run.h"
#include "app/runs/run_plan.h"
#include "isolation/worker_pool.h"

#include <memory>

namespace lacuna {

/// The worker processes in which a run simulates its models, where the options ask for them, or do not say and one of
/// the plugins is not of the installed set; null: models are simulated in this process. Each begins when it is needed.
std::unique_ptr<WorkerPool> worker_pool(const RunOptions& options, const OpenEeaRun& opened, int threads);

/// In a worker process: the experiment that its host works on, made ready as the host's is. Throws `Error` where a file
/// of it was changed meanwhile.
OpenEeaRun open_worker_run(const WorkerTask& task);

}  // namespace lacuna
