#pragma once

#include "tasks/sweep.h"
#include "tasks/task_plan.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What tasks are made of.
struct PlanOptions {
  std::vector<std::filesystem::path> experiments;
  std::vector<std::string> overrides;
  std::vector<std::filesystem::path> plugin_paths;
  std::optional<int> replicates;  ///< instead of each file's
  std::optional<std::uint64_t> seed;
  std::vector<std::string> sweeps;  ///< --sweep; a key that the file sweeps too has these values
  bool with_sweep_of_file = true;
  TaskKind kind = TaskKind::run;
};

/// Opens every experiment at every point of its sweep, and writes down what the tasks are and all that they follow
/// from: one task for each replicate of a run, or for each diagnosis. Throws `BadInput` with every problem of all of
/// them.
TaskPlan freeze_plan(const PlanOptions& options);

}  // namespace lacuna
