#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

struct sqlite3;
struct sqlite3_file;

namespace lacuna {

/// The database file of a connection, read as bytes past SQLite's cache and log. By SQLite's own handle: to close
/// another one would drop the locks of this process. Must not outlive the connection.
class RawFile {
 public:
  explicit RawFile(sqlite3* handle);
  /// Beyond the end of the file there are zeros; empty where it cannot be read.
  std::string read(std::uint64_t from, std::size_t size) const;
  std::uint64_t size() const;
  bool is_read_only() const;
  /// How many frames of the write-ahead log as it is now are known to have been brought into the file.
  std::uint32_t frames_in_file() const;
  /// Succeeds only while no other connection, of any process, uses the database.
  bool lock();
  void unlock();

 private:
  sqlite3* handle_;
  sqlite3_file* file_ = nullptr;
};

}  // namespace lacuna
