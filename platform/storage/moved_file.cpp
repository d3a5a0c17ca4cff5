#include "storage/moved_file.h"

#include <sqlite3.h>
#include <sys/stat.h>

#include <memory>

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

}  // namespace

std::optional<FileIdentity> identity_of(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return std::nullopt;
  return FileIdentity{status.st_dev, status.st_ino};
}

std::string keep_what_was_committed(const std::filesystem::path& file, sqlite3* handle, const FileIdentity& opened) {
  if (identity_of(file)) {
    return file.string() +
           ": was replaced by another file while it was open; nothing more is written. Use a name of its own for each";
  }
  const Whereabouts now = find(opened);
  if (!now.deleted && !now.place.empty() && complete_from_log(handle)) {
    return file.string() + ": was moved to " + now.place.string() +
           " while it was open; nothing more is written. What was stored until then is complete there; go on with that "
           "file, or move it back";
  }
  if (const std::filesystem::path copy = free_name(file); now.deleted && copy_to(copy, handle)) {
    return file.string() +
           ": was deleted while it was open; nothing more is written. What was stored until then is in " +
           copy.string() + "; rename it to go on with it";
  }
  return file.string() +
         ": was moved or deleted while it was open; nothing more is written. Put it back, with its -wal "
         "file beside it, or run again";
}

}  // namespace lacuna
