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

/// For a database that is no longer where it was opened, outside of a transaction: sees to it that what was committed
/// stays readable, and says in a sentence where it is. A moved file gets what its write-ahead log, which was left
/// behind, still holds; of a deleted one, a copy is made beside its old place. Where another file has taken the name,
/// the log is that one's, too, and nothing is touched.
std::string keep_what_was_committed(const std::filesystem::path& file, sqlite3* handle, const FileIdentity& opened);

}  // namespace lacuna
