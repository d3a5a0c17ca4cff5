#pragma once

#include "tasks/task_folder.h"

#include <chrono>
#include <filesystem>
#include <thread>

namespace lacuna {

/// While it lives, the plan's folder gets a checkpoint of a task now and then, so that a machine that is lost takes
/// little of it along.
class TaskCheckpoints {
 public:
  /// `database`: the task's, once it is there; it may be written meanwhile. `folder` must outlive it.
  TaskCheckpoints(const TaskFolder& folder, std::size_t number, std::filesystem::path database,
                  std::chrono::milliseconds between = std::chrono::minutes(5));

 private:
  std::jthread keeping_;
};

}  // namespace lacuna
