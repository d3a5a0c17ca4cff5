#include "storage/core/backup.h"

#include "foundation/interrupt.h"
#include "foundation/problem.h"
#include "foundation/whole_file.h"
#include "storage/core/database.h"
#include "storage/core/one_state.h"
#include "storage/core/storage_error.h"
#include "storage/files/connection.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <string>

namespace lacuna {
namespace {

constexpr int kPagesAtATime = 2048;  ///< 8 MiB: between two looks at whether to stop

void check_new(const std::filesystem::path& to) {
  std::error_code unknown;
  if (std::filesystem::exists(std::filesystem::symlink_status(to, unknown)))
    throw_problem({to.string()}, "is there already; name a new file, or move it away");
  if (const auto reason = why_not_writable(to)) throw_problem({to.string()}, "cannot be written: " + *reason);
}

/// The draft is nobody's yet, and comes to the disk as a whole: it needs no journal.
void copy_pages(const Database& from, const std::filesystem::path& draft, const std::function<void(double)>& progress) {
  const auto into = open_connection(draft.string(), SQLITE_OPEN_READWRITE);
  into->exec("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF");
  SQLite::Backup backup(*into, from.connection());
  int result = SQLITE_OK;
  while (result != SQLITE_DONE) {
    throw_if_interrupted();
    result = backup.executeStep(kPagesAtATime);
    if (result != SQLITE_OK && result != SQLITE_DONE) throw_storage_error(from.file(), result, sqlite3_errstr(result));
    const double pages = std::max(1, backup.getTotalPageCount());
    if (progress) progress(1.0 - backup.getRemainingPageCount() / pages);
  }
}

/// Through a connection that takes no locks and makes no log beside the draft.
void check_pages(const std::filesystem::path& database, const std::filesystem::path& draft) {
  const auto copy = open_connection(uri_of(draft.string()) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  end_when_interrupted(*copy);
  const std::string found = copy->execAndGet("PRAGMA integrity_check(1)").getString();
  if (found != "ok")
    throw DamagedDatabase(database.string() + ": is damaged (" + found +
                          "), so no backup was made; keep the file, and go back to an earlier backup");
}

}  // namespace

std::uintmax_t back_up(const std::filesystem::path& database, const std::filesystem::path& to,
                       const std::function<void(double)>& progress) {
  const Database from = Database::open_read_only(database);
  check_new(to);
  WholeFile whole(to, Link::replaced);
  const std::filesystem::path draft = whole.named_draft();
  try {
    hold_one_state(from);
    copy_pages(from, draft, progress);
    check_pages(database, draft);
  } catch (const SQLite::Exception& error) {
    throw_storage_error(error.getErrorCode() == SQLITE_FULL ? to : database, error);
  }
  const std::uintmax_t bytes = std::filesystem::file_size(draft);
  whole.publish_as_new();
  return bytes;
}

}  // namespace lacuna
