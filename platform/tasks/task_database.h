#pragma once

#include "foundation/processes/stop.h"
#include "tasks/task_plan.h"

#include <filesystem>
#include <optional>
#include <string>

namespace lacuna {

/// Expected state of a task's database.
enum class TaskDatabase {
  checkpoint,  ///< some of its results, or none yet, in a sound file
  shard        ///< all of them
};

/// Why a database cannot be used as that of a task.
struct TaskDatabaseFault {
  std::string reason;          ///< a clause, as in "is damaged"
  bool is_of_database = true;  ///< it is not what it should be; false: another one would not do better
};

/// Nothing where it can be used. Throws `Interrupted`.
std::optional<TaskDatabaseFault> why_not_of_task(const std::filesystem::path& database, const Task& task,
                                                 TaskDatabase expected, const Stop& stop = {});

}  // namespace lacuna
