#include "storage/integrity/backup.h"

#include "foundation/text/problem.h"
#include "foundation/files/whole_file.h"
#include "storage/core/database.h"
#include "storage/core/one_state.h"
#include "storage/integrity/seal.h"
#include "storage/core/storage_error.h"
#include "storage/files/connection.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <algorithm>
#include <memory>
#include <string>

namespace lacuna {
namespace {

constexpr int kPagesAtATime = 2048;  ///< 8 MiB: between two looks at whether to stop

using Progress = std::function<void(double)>;

void check_new(const std::filesystem::path& to) {
  std::error_code unknown;
  if (std::filesystem::exists(std::filesystem::symlink_status(to, unknown)))
    throw_problem({to.string()}, "already exists; name a new file, or move it away");
  if (const auto reason = why_not_writable(to)) throw_problem({to.string()}, "cannot be written: " + *reason);
}

/// The database is only read, so a failure to write concerns the copy.
[[noreturn]] void throw_copy_error(const std::filesystem::path& from, const std::filesystem::path& to, int code,
                                   const std::string& message) {
  const bool is_of_copy = (code & 0xff) == SQLITE_FULL || code == SQLITE_IOERR_WRITE || code == SQLITE_IOERR_FSYNC;
  throw_storage_error(is_of_copy ? to : from, code, message);
}

[[noreturn]] void throw_copy_error(const std::filesystem::path& from, const std::filesystem::path& to,
                                   const SQLite::Exception& error) {
  const int extended = error.getExtendedErrorCode();
  throw_copy_error(from, to, extended > 0 ? extended : error.getErrorCode(), error.what());
}

/// Nobody uses the draft yet, and it gets to the disk as a whole, so it needs neither journal nor locks.
void copy_pages(const Database& from, const std::filesystem::path& to, const std::filesystem::path& draft,
                const Progress& progress) {
  const auto into = open_connection(uri_of(draft.string()) + "?nolock=1", SQLITE_OPEN_READWRITE | SQLITE_OPEN_URI);
  into->exec("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF");
  SQLite::Backup backup(*into, from.connection());
  int result = SQLITE_OK;
  while (result != SQLITE_DONE) {
    result = backup.executeStep(kPagesAtATime);
    if (result != SQLITE_OK && result != SQLITE_DONE) throw_copy_error(from.file(), to, result, sqlite3_errstr(result));
    const double pages = std::max(1, backup.getTotalPageCount());
    if (progress) progress(1.0 - backup.getRemainingPageCount() / pages);
  }
}

[[noreturn]] void throw_damaged(const std::filesystem::path& database, const std::string& found) {
  throw DamagedDatabase(database.string() + ": is damaged (" + found +
                        "), so no backup was made; keep the file, and restore an earlier backup");
}

std::unique_ptr<SQLite::Database> open_draft(const std::filesystem::path& draft) {
  return open_connection(uri_of(draft.string()) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

/// Through a connection that takes no locks and makes no log beside the draft.
void check_pages(const std::filesystem::path& database, SQLite::Database& copy) {
  const std::string found = copy.execAndGet("PRAGMA integrity_check(1)").getString();
  if (found != "ok") throw_damaged(database, found);
}

void check_content(const Database& database) {
  const SealCheck seals = check_seals(database);
  if (seals.broken.empty()) return;
  const BrokenSeal& first = seals.broken.front();
  throw_damaged(database.file(), "run " + std::to_string(first.run.value) + ", table " + first.table +
                                     ": changed since the run ended: " + first.reason);
}

bool is_larger(const std::filesystem::path& file, const std::filesystem::path& than) {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(file, missing);
  return !missing && size > std::filesystem::file_size(than);
}

}  // namespace

std::uintmax_t back_up(const std::filesystem::path& database, const std::filesystem::path& to, const Stop& stop,
                       const Progress& progress) {
  const Database from = Database::open_read_only(database, stop);
  check_new(to);
  WholeFile whole(to, Link::replaced);
  const std::filesystem::path draft = whole.named_draft();
  try {
    hold_one_state(from);
    copy_pages(from, to, draft, [&](double part) {
      stop.throw_if_due();
      if (progress) progress(part);
    });
    const auto copy = open_draft(draft);
    end_when_due(*copy, from.stop());
    check_pages(database, *copy);
  } catch (const SQLite::Exception& error) {
    throw_copy_error(database, to, error);
  }
  check_content(from);
  const std::uintmax_t bytes = std::filesystem::file_size(draft);
  whole.publish_as_new();
  return bytes;
}

void hand_on(const std::filesystem::path& database, const std::filesystem::path& to) {
  const Database from = Database::open_read_only(database);
  WholeFile whole(to, Link::replaced);
  const std::filesystem::path draft = whole.named_draft();
  try {
    hold_one_state(from);
    copy_pages(from, to, draft, {});
    check_pages(database, *open_draft(draft));
  } catch (const SQLite::Exception& error) {
    throw_copy_error(database, to, error);
  }
  if (!is_larger(to, draft)) whole.publish();
}

}  // namespace lacuna
