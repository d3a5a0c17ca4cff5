#include "tasks/task_database.h"

#include "foundation/guarded_call.h"
#include "foundation/interrupt.h"
#include "storage/core/storage_error.h"
#include "storage/files/log_left.h"
#include "storage/queries/runs_of_task.h"

namespace lacuna {

std::optional<TaskDatabaseFault> why_not_of_task(const std::filesystem::path& database, const Task& task,
                                                 TaskDatabase expected) try {
  const LogLeft log(database);
  const Database opened = Database::open_read_only(database);
  if (expected == TaskDatabase::checkpoint) require_sound_pages(opened);
  const RunsOfTask runs = runs_of_task(opened, task.id);
  if (runs.has_others) return TaskDatabaseFault{"holds other results than those of the task"};
  if (!runs.has_begun && expected == TaskDatabase::shard) return TaskDatabaseFault{"holds no results of the task"};
  if (expected == TaskDatabase::shard && !runs.is_done) return TaskDatabaseFault{"does not hold the end of the task"};
  return std::nullopt;
} catch (const Interrupted&) {
  throw;
} catch (const DamagedDatabase&) {
  return TaskDatabaseFault{"is damaged"};
} catch (const Error& unusable) {
  return TaskDatabaseFault{reason_of(unusable), false};
}

}  // namespace lacuna
