#pragma once

#include "tasks/task_plan.h"

#include <filesystem>
#include <optional>
#include <string>

namespace lacuna {

/// What a database is expected to be of a task.
enum class TaskDatabase {
  checkpoint,  ///< some of its results, in a sound file
  shard        ///< all of them
};

/// Why a database is not that of the task, a clause, as in "is damaged"; nothing where it is. Throws `Interrupted`.
std::optional<std::string> why_not_of_task(const std::filesystem::path& database, const Task& task,
                                           TaskDatabase expected);

}  // namespace lacuna
