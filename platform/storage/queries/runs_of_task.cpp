#include "storage/queries/runs_of_task.h"

#include "storage/core/statement.h"
#include "storage/core/storage_error.h"
#include "storage/results/result_store.h"

namespace lacuna {

RunsOfTask runs_of_task(const Database& database, const std::string& task) {
  RunsOfTask found;
  Statement run(database, "SELECT number, identity, coalesce(ending, '') FROM run");
  while (run.step()) {
    if (run.text(1) != identity_of_run(task, RunId{run.integer(0)})) {
      found.has_others = true;
      continue;
    }
    found.has_begun = true;
    found.is_done = found.is_done || run.text(2) == "done";
  }
  return found;
}

void require_sound_pages(const Database& database) {
  Statement found(database, "PRAGMA quick_check(1)");
  if (!found.step() || found.text(0) != "ok")
    throw DamagedDatabase(database.file().string() + ": is damaged (" + found.text(0) + ")");
}

}  // namespace lacuna
