#pragma once

#include "storage/core/database.h"

#include <string>

namespace lacuna {

/// What a database has of a task (`RunRecord::task`).
struct RunsOfTask {
  bool has_begun = false;   ///< a run of the task is there
  bool is_done = false;     ///< one that is done
  bool has_others = false;  ///< runs that are not the task's
};

RunsOfTask runs_of_task(const Database& database, const std::string& task);

/// Throws `DamagedDatabase` where the file's pages are not what SQLite wrote.
void require_sound_pages(const Database& database);

}  // namespace lacuna
