#pragma once

#include <filesystem>
#include <optional>
#include <string>

struct sqlite3;

namespace lacuna {

/// Which file it is, whatever its name.
struct FileIdentity {
  unsigned long device = 0;
  unsigned long number = 0;
  bool operator==(const FileIdentity&) const = default;
};
/// Nothing where there is no file of that name.
std::optional<FileIdentity> identity_of(const std::filesystem::path& file);

/// Where a database was opened for writing.
struct OpenPlace {
  FileIdentity file;
  std::filesystem::path log;               ///< its write-ahead log
  std::optional<FileIdentity> log_itself;  ///< which file that was then
};

/// For a database that is no longer where it was opened, outside of a transaction: sees to it that what was committed
/// stays readable, and says in a sentence where it is. A moved file gets what its write-ahead log, which was left
/// behind, still holds; of one that was deleted or written over by a rename, a copy is made beside its old place. Then
/// the log goes, which would be played into whatever file has the name now; it is set aside where nothing could be
/// kept.
std::string keep_what_was_committed(const std::filesystem::path& file, sqlite3* handle, const OpenPlace& opened);

/// For a database whose file was written over by another program, outside of a transaction: the file stays as it is,
/// also when the connection is closed, and the log, whose pages would destroy it, is set aside. Says so in a sentence.
std::string leave_what_was_copied_over(const std::filesystem::path& file, sqlite3* handle, const OpenPlace& opened);

/// The sentence for a database into which another program has brought other content by SQLite itself: the log holds it.
std::string leave_what_was_restored_over(const std::filesystem::path& file);

}  // namespace lacuna
