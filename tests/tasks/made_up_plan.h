#pragma once

#include "foundation/digest.h"
#include "support/test_folder.h"
#include "tasks/task_plan.h"

#include <fstream>
#include <string>

namespace lacuna::test {

inline void write_text(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

/// Three replicates of a run and a diagnosis that follow from one file, "rig.toml" in the folder.
inline TaskPlan made_up_plan(const std::filesystem::path& folder) {
  write_text(folder / "rig.toml", "[experiment]\n");
  TaskPlan plan{.command = "lacuna plan rig.toml", .plugin_paths = {"/opt/plugins"}, .inputs = {}, .tasks = {}};
  plan.inputs.push_back({folder / "rig.toml", sha256_of_file(folder / "rig.toml")});
  for (int replicate = 1; replicate <= 4; ++replicate) {
    Task task;
    task.kind = replicate < 4 ? TaskKind::run : TaskKind::diagnosis;
    task.experiment = folder / "rig.toml";
    task.name = "rig";
    task.settings = {"engine.step=\"1 ms\""};
    task.seed = 7;
    task.replicate = replicate < 4 ? replicate : 1;
    task.inputs = {0};
    task.id = id_of(task, plan.inputs);
    plan.tasks.push_back(task);
  }
  return plan;
}

}  // namespace lacuna::test
