#include "storage/files/moved_file.h"

#include "storage/files/foreign_log.h"

#include <sqlite3.h>
#include <sys/stat.h>

#include <memory>
#include <string_view>

namespace lacuna {
namespace {

/// Where a file that this process has open is now.
struct Whereabouts {
  bool deleted = false;
  std::filesystem::path place;  ///< empty: not known
};

Whereabouts find(const FileIdentity& opened) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", ignored)) {
    if (identity_of(entry.path()) != opened) continue;
    struct stat status {};
    if (stat(entry.path().c_str(), &status) == 0 && status.st_nlink == 0) return {.deleted = true, .place = {}};
    return {.deleted = false, .place = std::filesystem::read_symlink(entry.path(), ignored)};
  }
  return {};
}

bool complete_from_log(sqlite3* handle) {
  return sqlite3_wal_checkpoint_v2(handle, "main", SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr) == SQLITE_OK;
}

std::filesystem::path free_name(const std::filesystem::path& file) {
  std::filesystem::path name = file.string() + ".rescued";
  for (int i = 2; std::filesystem::exists(name); ++i) name = file.string() + ".rescued-" + std::to_string(i);
  return name;
}

bool copy_to(const std::filesystem::path& copy, sqlite3* handle) {
  const std::unique_ptr<char, void (*)(void*)> statement(sqlite3_mprintf("VACUUM INTO %Q", copy.c_str()),
                                                         &sqlite3_free);
  return sqlite3_exec(handle, statement.get(), nullptr, nullptr, nullptr) == SQLITE_OK;
}

bool log_is_there(const OpenPlace& opened) { return opened.log_itself && identity_of(opened.log) == opened.log_itself; }

std::filesystem::path index_of(const std::filesystem::path& log) {
  std::string name = log.string();
  return name.replace(name.size() - std::string_view("-wal").size(), std::string::npos, "-shm");
}

/// Its content has been moved by now. Another process may have put its log in the same place.
void remove_log(const OpenPlace& opened) {
  if (!log_is_there(opened)) return;
  std::error_code ignored;
  std::filesystem::remove(index_of(opened.log), ignored);
  std::filesystem::remove(opened.log, ignored);
}

std::string set_log_aside(const OpenPlace& opened) {
  if (!log_is_there(opened)) return {};
  std::error_code ignored;
  std::filesystem::remove(index_of(opened.log), ignored);
  try {
    return "; its log was set aside as " + set_aside(opened.log).string();
  } catch (const std::filesystem::filesystem_error&) {
    return "; its log is " + opened.log.string() + ", which must be moved away before the new file is opened";
  }
}

std::string written_over(const std::filesystem::path& file, const std::string& log) {
  return file.string() +
         ": was overwritten by another program while it was open; it stays as it is, and nothing more is written. The "
         "earlier rows are lost" +
         log + ". Run again with --db and another file";
}

}  // namespace

std::optional<FileIdentity> identity_of(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return std::nullopt;
  return FileIdentity{status.st_dev, status.st_ino};
}

std::string keep_what_was_committed(const std::filesystem::path& file, sqlite3* handle, const OpenPlace& opened) {
  const bool replaced = identity_of(file).has_value();
  const Whereabouts now = find(opened.file);
  const std::string nothing_more = " while it was open; nothing more is written. The rows stored so far are ";
  const std::string here = file.string() + (replaced ? ": was replaced by another file" : "");
  if (!now.deleted && !now.place.empty() && complete_from_log(handle)) {
    remove_log(opened);
    return (replaced ? here + " and moved to " : here + ": was moved to ") + now.place.string() + nothing_more +
           "complete there; continue with that file" + (replaced ? "" : ", or move it back");
  }
  if (const std::filesystem::path copy = free_name(file); copy_to(copy, handle)) {
    remove_log(opened);
    return (replaced      ? here
            : now.deleted ? here + ": was deleted"
                          : here + ": was moved") +
           nothing_more + "in " + copy.string() + "; rename it to continue with it";
  }
  const std::string log = replaced ? set_log_aside(opened) : std::string();
  return (replaced ? here : here + ": was moved or deleted") +
         " while it was open; nothing more is written, and the stored rows could not be copied" +
         (replaced ? log : ". Put it back, with its -wal file beside it, or run again");
}

std::string leave_what_was_copied_over(const std::filesystem::path& file, sqlite3* handle, const OpenPlace& opened) {
  sqlite3_db_config(handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  if (has_content(opened.log)) return written_over(file, set_log_aside(opened));
  remove_log(opened);
  return written_over(file, "");
}

std::string leave_what_was_restored_over(const std::filesystem::path& file) { return written_over(file, ""); }

}  // namespace lacuna
