#pragma once

#include "foundation/processes/stop.h"
#include "storage/files/moved_file.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct sqlite3;
namespace SQLite {
class Database;
}

namespace lacuna {

class ContentWatch;

/// One numbered step of the schema.
struct Migration {
  int number = 0;  ///< the `user_version` after it
  std::string sql;
};

/// The migrations that this program has built in (schema/NNNN_*.sql), ascending.
const std::vector<Migration>& schema_migrations();
/// schema/views.sql
const std::string& schema_views();

/// Set in the header of each of our files: "Lacn".
inline constexpr int kApplicationId = 0x4C61636E;

/// A connection to a database file. Foreign keys are enforced; writing goes through a
/// write-ahead log that survives a crash and a power cut once `commit` has returned.
/// One thread at a time. Everything throws `Error` with a sentence that names the file: newer than
/// this program, damaged, locked by another writer, read-only, disk full, moved or deleted while
/// open; `BadInput` where the wrong file was named: none, a folder, no database, not ours. A log beside the file that
/// is not the file's is set aside first (foreign_log.h). Where the file was replaced while it was open for writing,
/// what was committed is kept (moved_file.h); where another was copied over it, that one stays as it is
/// (content_watch.h): at the end of the object at the latest, which then says so on standard error.
class Database {
 public:
  /// Opens for writing; creates the file or brings it up to date, keeping a copy
  /// (`FILE.before-version-N`) of one that has to be migrated. `stop`: of the work that opens it.
  static Database open(const std::filesystem::path& file, const Stop& stop = {});
  /// The same with other migrations, for tests of migrating itself; no views.
  static Database open(const std::filesystem::path& file, const std::vector<Migration>& migrations);
  /// Opens for reading what exists. Nothing can be written through it. Of a file of an older version a temporary copy
  /// is brought up to date and read. Long questions end with `Interrupted` when `stop` is due.
  static Database open_read_only(const std::filesystem::path& file, const Stop& stop = {});
  /// Opens for writing a temporary copy of what exists, brought up to date, which ends with the object: for commands
  /// that find their answer in a file that they may not write to.
  static Database open_copy(const std::filesystem::path& file, const Stop& stop = {});
  /// Opens a database without tables that is not a user's file: a new file or, without a name, memory.
  static Database open_blank(const std::filesystem::path& file = {});

  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;
  ~Database();

  const std::filesystem::path& file() const { return file_; }
  /// What ends the work early for which it was opened: for what reads or copies many rows.
  const Stop& stop() const { return *stop_; }
  /// For storage/ alone.
  SQLite::Database& connection() const { return *connection_; }
  sqlite3* handle() const;
  /// How long to wait for another writer before giving up; 5 s unless said otherwise.
  void wait_for_writers(std::chrono::milliseconds longest);
  bool in_transaction() const;
  void execute(const std::string& statements);
  /// Throws `Error` if the file is no longer where it was opened or no longer what it was: what is written would be
  /// lost, or destroy another file. What can be kept is kept, as moved_file.h says. To be called outside of a
  /// transaction, which `is_in_place` need not be.
  void check_in_place();
  bool is_in_place() const;
  /// Whether the file was moved, deleted or replaced by another, so that what was stored is kept elsewhere.
  bool has_moved() const;
  /// Of a transaction that writes, after `check_in_place`. For `Transaction` alone.
  void begin();
  /// With the mark of log_content.h. For `Transaction` alone.
  void commit();
  /// Does nothing outside of a transaction.
  void roll_back();

 private:
  explicit Database(std::filesystem::path file, const Stop& stop = {});
  void read_copy_of_this_version();
  void begin_marks();
  void check_continued();
  std::filesystem::path file_;
  std::unique_ptr<const Stop> stop_;  ///< at one place, because SQLite asks it through the connection
  std::unique_ptr<SQLite::Database> connection_;
  std::optional<OpenPlace> place_;       ///< of a file that was opened for writing
  std::unique_ptr<ContentWatch> watch_;  ///< of one whose commits are marked
  std::string lost_;                     ///< why nothing can be written any more
};

/// Whether a database that is there, or could be made there, may be written. A write-ahead log needs the folder as
/// well.
bool is_writable(const std::filesystem::path& database);

/// A transaction: what is not committed when it ends is rolled back. Begun inside another, it is
/// part of that one.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool outermost_;
  bool open_ = true;
};

}  // namespace lacuna
