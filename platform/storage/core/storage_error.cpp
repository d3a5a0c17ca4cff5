#include "storage/core/storage_error.h"

#include "foundation/processes/stop.h"
#include "foundation/text/problem.h"
#include "foundation/processes/process_limits.h"

#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>
#include <unistd.h>

namespace lacuna {
namespace {

/// Also where a part of the file or of its log is not there any more.
bool is_damage(int code) { return (code & 0xff) == SQLITE_CORRUPT || code == SQLITE_IOERR_SHORT_READ; }

/// What the primary code means and what to do, without the file's name in front.
std::string sentence(int code, const std::string& message) {
  if (code == SQLITE_IOERR_WRITE || code == SQLITE_IOERR_SHMSIZE)
    return "cannot grow: the disk or the quota is full, or files may not grow this large (ulimit -f); make room and "
           "repeat the command (lacuna run: with --resume)";
  if (is_damage(code))
    return "is damaged (" + message + "); restore a backup, or recover the readable part with: sqlite3 FILE .recover";
  switch (code & 0xff) {
    case SQLITE_NOTADB: return "is not a Lacuna database; name another file, or move this one away";
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return "is in use by another process; wait until that has ended, then try again";
    case SQLITE_FULL:
      return "cannot grow: the disk or the quota is full; make room and repeat the command (lacuna run: with "
             "--resume)";
    case SQLITE_READONLY: return "is read-only; check the permissions of the file and of its folder, or copy it";
    case SQLITE_CANTOPEN: return "cannot be opened; check that its folder exists and its permissions";
    case SQLITE_PERM:
    case SQLITE_AUTH: return "may not be accessed (" + message + "); check its permissions";
    case SQLITE_IOERR:
      return "cannot be read or written (" + message +
             "); check the disk, its quota, its connection and the largest size of files (ulimit -f), then run again";
    case SQLITE_NOMEM: return "needs more memory than is available; free some, or request less at once";
    case SQLITE_TOOBIG: return "has a value that is too long (" + message + ")";
    case SQLITE_CONSTRAINT:
      return "refused a record (" + message + "); this is a fault of the program, please report it";
    default: return "cannot be used (" + message + ")";
  }
}

/// Whether the file itself could be used, were it not for its folder.
bool folder_is_read_only(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (::access(folder.c_str(), X_OK) != 0 || ::access(folder.c_str(), W_OK) == 0) return false;
  return ::access(file.c_str(), F_OK) != 0 || ::access(file.c_str(), R_OK | W_OK) == 0;
}

}  // namespace

void throw_storage_error(const std::filesystem::path& file, int extended_code, const std::string& message) {
  const int code = extended_code & 0xff;
  if ((code == SQLITE_CANTOPEN || code == SQLITE_READONLY) && folder_is_read_only(file))
    throw Error(file.string() +
                ": cannot be written: its folder is read-only; name a database elsewhere (--db FILE, where "
                "the command has it)");
  if (code == SQLITE_INTERRUPT) throw Interrupted(file.string() + ": interrupted during reading");
  if ((extended_code & 0xff) == SQLITE_NOTADB) throw_problem({file.string()}, sentence(extended_code, message));
  if (code == SQLITE_CANTOPEN)
    if (const std::string used_up = used_up_descriptors(); !used_up.empty())
      throw Error(file.string() + ": cannot be opened: " + used_up);
  const std::string text = file.string() + ": " + sentence(extended_code, message);
  if (is_damage(extended_code)) throw DamagedDatabase(text);
  throw Error(text);
}

void throw_storage_error(const std::filesystem::path& file, const SQLite::Exception& error) {
  throw_storage_error(file, error.getExtendedErrorCode() > 0 ? error.getExtendedErrorCode() : error.getErrorCode(),
                      error.what());
}

void throw_read_only(const std::filesystem::path& file) { throw_storage_error(file, SQLITE_READONLY, ""); }

}  // namespace lacuna
