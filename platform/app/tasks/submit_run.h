#pragma once

#include "app/runs/run_plan.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace lacuna {

/// Where a run's replicates are carried out.
struct SlurmOptions {
  bool wanted = false;              ///< else on this machine
  std::vector<std::string> sbatch;  ///< further options of `sbatch`
};

void add_slurm_options(CLI::App& command, SlurmOptions& options);

/// Freezes the replicates as tasks, and gives Slurm those that are not done and a job that merges all into the
/// database. Throws `BadInput`, `Error` where `sbatch` refuses.
void submit_run(const RunOptions& options, const SlurmOptions& slurm);

}  // namespace lacuna
