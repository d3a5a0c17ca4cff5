#include "tasks/task_database.h"

#include "foundation/processes/guarded_call.h"
#include "foundation/text/problem.h"
#include "storage/core/storage_error.h"
#include "storage/files/log_left.h"
#include "storage/queries/runs_of_task.h"

namespace lacuna {
namespace {

/// Of the file, which whoever reports the fault names.
std::string without_name(const std::string& sentence, const std::filesystem::path& file) {
  const std::string name = file.string() + ": ";
  return sentence.starts_with(name) ? sentence.substr(name.size()) : sentence;
}

}  // namespace

std::optional<TaskDatabaseFault> why_not_of_task(const std::filesystem::path& database, const Task& task,
                                                 TaskDatabase expected, const Stop& stop) try {
  const LogLeft log(database);
  const Database opened = Database::open_read_only(database, stop);
  if (expected == TaskDatabase::checkpoint) require_sound_pages(opened);
  const RunsOfTask runs = runs_of_task(opened, task.id);
  if (runs.has_others) return TaskDatabaseFault{"contains results of another task"};
  if (!runs.has_begun && expected == TaskDatabase::shard) return TaskDatabaseFault{"contains no results of the task"};
  if (expected == TaskDatabase::shard && !runs.is_done) return TaskDatabaseFault{"contains an unfinished task"};
  return std::nullopt;
} catch (const Interrupted&) {
  throw;
} catch (const DamagedDatabase&) {
  return TaskDatabaseFault{"is damaged"};
} catch (const BadInput&) {
  return TaskDatabaseFault{"is not a Lacuna database"};
} catch (const Error& unusable) {
  return TaskDatabaseFault{without_name(reason_of(unusable), database), false};
}

}  // namespace lacuna
