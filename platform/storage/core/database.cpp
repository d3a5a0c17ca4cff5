#include "storage/core/database.h"

#include "foundation/files/allowed_files.h"
#include "foundation/text/problem.h"
#include "storage/core/migrate.h"
#include "storage/core/statement.h"
#include "storage/core/storage_error.h"
#include "storage/files/connection.h"
#include "storage/files/content_watch.h"
#include "storage/files/foreign_log.h"
#include "storage/files/log_content.h"

#include <lacuna/error.h>

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <thread>

namespace lacuna {
namespace {

constexpr int kPauseMs = 5;

/// SQLite would wait for who writes to a pipe, take a device for a database, and some names for no files.
void check_place(const std::filesystem::path& file) {
  const std::string name = file.string();
  if (name.starts_with("file:") || name == ":memory:")
    throw_problem({name}, "SQLite does not accept this as a file name; write ./" + name);
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(file, unknown);
  if (std::filesystem::is_directory(status)) throw_problem({file.string()}, "is a folder; name a database file");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw_problem({file.string()}, "is a pipe, a socket or a device, not a regular file; name a database file");
  if (const std::filesystem::path folder = file.parent_path(); !folder.empty() && !std::filesystem::exists(folder))
    throw_problem({file.string()}, "cannot be opened: there is no folder " + folder.string());
}

std::unique_ptr<SQLite::Database> connect(const std::filesystem::path& file, const std::string& name, int flags) {
  check_place(file);
  try {
    return open_connection(name, flags);
  } catch (const SQLite::Exception& error) {
    throw_storage_error(file, error);
  }
}

/// SQLite does not wait for others in this step, so we do.
void keep_write_ahead_log(const std::filesystem::path& file, sqlite3* handle) {
  const auto take = [](void* mode, int, char** values, char**) {
    *static_cast<std::string*>(mode) = values[0];
    return 0;
  };
  std::string mode;
  int result = SQLITE_BUSY;
  for (int waited = 0; result == SQLITE_BUSY && waited < kBusyTimeoutMs; waited += kPauseMs) {
    if (waited > 0) std::this_thread::sleep_for(std::chrono::milliseconds(kPauseMs));
    result = sqlite3_exec(handle, "PRAGMA journal_mode = WAL", take, &mode, nullptr) & 0xff;
  }
  if (result != SQLITE_OK) throw_storage_error(file, result, sqlite3_errmsg(handle));
  if (mode != "wal") {
    throw Error(file.string() + ": this folder cannot hold a write-ahead log; use --db with a file on a local disk");
  }
}

constexpr const char* kMarkOfNow = "SELECT 1 FROM schema_text WHERE name = 'log'";

/// See log_content.h.
std::string next_mark() {
  constexpr std::size_t kNow = kMarkWord.size() + kNoMark.size() + 2;  // counted from 1
  return fmt::format("UPDATE schema_text SET sha256 = '{}' || substr(sha256, {}) || ' ' || ? WHERE name = 'log'",
                     kMarkWord, kNow);
}

std::string new_mark() {
  std::array<unsigned char, kNoMark.size() / 2> bytes{};
  sqlite3_randomness(static_cast<int>(bytes.size()), bytes.data());
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

std::string first_mark() {
  return fmt::format(
      "INSERT OR IGNORE INTO schema_text (name, sha256) VALUES ('log', '{}{} ' || lower(hex(randomblob(16))))",
      kMarkWord, kNoMark);
}

}  // namespace

Database::Database(std::filesystem::path file, const Stop& stop)
    : file_(std::move(file)), stop_(std::make_unique<const Stop>(stop)) {}
Database::Database(Database&&) noexcept = default;

Database& Database::operator=(Database&& other) noexcept {
  const Database old(std::move(*this));  // ends as any other
  file_ = std::move(other.file_);
  connection_ = std::move(other.connection_);
  stop_ = std::move(other.stop_);
  place_ = std::move(other.place_);
  watch_ = std::move(other.watch_);
  lost_ = std::move(other.lost_);
  return *this;
}

Database::~Database() {
  if (!connection_ || !place_ || !lost_.empty()) return;
  try {
    if (is_in_place()) return;
    roll_back();
    check_in_place();
  } catch (const Error& lost) {
    std::fprintf(stderr, "%s\n", lost.what());
  } catch (const std::exception&) {
    // SQLite keeps the log where it is, and whoever opens the file next looks at it.
  }
}

Database Database::open(const std::filesystem::path& file, const std::vector<Migration>& migrations) {
  check_may_write(file);
  Database database(file);
  database.connection_ = connect(file, file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (sqlite3_db_readonly(database.handle(), "main") == 1) throw_storage_error(file, SQLITE_READONLY, "");
  if (const std::string problem = put_foreign_log_aside(file); !problem.empty())
    throw Error(problem + "; move it away, or copy " + file.string() + " alone to another folder");
  check_header(database, migrations);
  // Only now may anything be written to it: it is ours, or empty.
  keep_write_ahead_log(file, database.handle());
  database.execute("PRAGMA synchronous = FULL");
  migrate(database, migrations);
  const std::filesystem::path log = beside(file, "-wal");
  database.place_ = OpenPlace{identity_of(file).value_or(FileIdentity{}), log, identity_of(log)};
  return database;
}

Database Database::open(const std::filesystem::path& file, const Stop& stop) {
  Database database = open(file, schema_migrations());
  database.stop_ = std::make_unique<const Stop>(stop);
  refresh_views(database, schema_views());
  database.begin_marks();
  return database;
}

void Database::begin_marks() {
  if (!Statement(*this, kMarkOfNow).step()) {
    execute(first_mark());
    // Into the file itself; where a reader is in the way, a later checkpoint does it.
    wait_for_writers(std::chrono::milliseconds(0));
    sqlite3_wal_checkpoint_v2(handle(), "main", SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
    wait_for_writers(std::chrono::milliseconds(kBusyTimeoutMs));
  }
  watch_ = std::make_unique<ContentWatch>(file_, handle());
}

void Database::read_copy_of_this_version() {
  // SQLite keeps a database without a name in a temporary file that ends with the connection.
  std::unique_ptr<SQLite::Database> copy = connect(file_, "", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  try {
    if (const int result = SQLite::Backup(*copy, *connection_).executeStep(); result != SQLITE_DONE)
      throw_storage_error(file_, result, sqlite3_errstr(result));
  } catch (const SQLite::Exception& error) {
    throw_storage_error(file_, error);
  }
  connection_ = std::move(copy);
  bring_up_to_date(*this, schema_migrations());
  refresh_views(*this, schema_views());
}

Database Database::open_read_only(const std::filesystem::path& file, const Stop& stop) {
  check_may_read(file);
  if (!std::filesystem::exists(file)) {
    throw_problem({file.string()},
                  "no such database; `lacuna compare` and `lacuna run` make one from an experiment file");
  }
  check_place(file);
  Database database(file, stop);
  const std::string foreign_log = put_foreign_log_aside(file);
  if (!foreign_log.empty()) {
    fmt::print(stderr, "{}; {} is read without it\n", foreign_log, file.string());
    database.connection_ =
        connect(file, uri_of(file.string()) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  } else {
    database.connection_ = connect(file, file.string(), SQLITE_OPEN_READONLY);
  }
  try {
    check_header(database, schema_migrations());
  } catch (const Error&) {
    // On read-only media, and on full ones, the write-ahead log's index cannot be made. Without a log none is needed.
    const int code = sqlite3_extended_errcode(database.handle());
    const bool cannot_open = (code & 0xff) == SQLITE_CANTOPEN || (code & 0xff) == SQLITE_READONLY ||
                             (code & 0xff) == SQLITE_FULL || code == SQLITE_IOERR_SHMSIZE;
    if (!cannot_open) throw;
    if (has_content(file.string() + "-wal")) {
      throw Error(file.string() +
                  ": has changes in its -wal file, and these cannot be read in a read-only folder or on a full disk; "
                  "copy both files to a writable folder and read them there");
    }
    database.connection_ =
        connect(file, uri_of(file.string()) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    check_header(database, schema_migrations());
  }
  if (!is_of_version(database, schema_migrations())) database.read_copy_of_this_version();
  database.execute("PRAGMA query_only = ON");
  end_when_due(database.connection(), database.stop());
  return database;
}

Database Database::open_copy(const std::filesystem::path& file, const Stop& stop) {
  Database database = open_read_only(file, stop);
  database.read_copy_of_this_version();
  return database;
}

Database Database::open_blank(const std::filesystem::path& file) {
  Database database(file.empty() ? "a database in memory" : file);
  database.connection_ =
      connect(file, file.empty() ? ":memory:" : file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  return database;
}

bool is_writable(const std::filesystem::path& database) {
  const std::filesystem::path folder = database.has_parent_path() ? database.parent_path() : ".";
  const bool exists = ::access(database.c_str(), F_OK) == 0;
  return ::access(folder.c_str(), W_OK) == 0 && (!exists || ::access(database.c_str(), W_OK) == 0);
}

sqlite3* Database::handle() const { return connection_->getHandle(); }

void Database::wait_for_writers(std::chrono::milliseconds longest) {
  connection_->setBusyTimeout(static_cast<int>(longest.count()));
}

bool Database::in_transaction() const { return sqlite3_get_autocommit(handle()) == 0; }

void Database::execute(const std::string& statements) try {
  connection_->exec(statements);
} catch (const SQLite::Exception& error) {
  throw_storage_error(file_, error);
}

void Database::begin() {
  execute("BEGIN IMMEDIATE");
  try {
    check_continued();
  } catch (...) {
    roll_back();
    throw;
  }
}

void Database::commit() {
  static const std::string kNextMark = next_mark();
  const std::string mark = new_mark();
  if (watch_) Statement(*this, kNextMark.c_str()).run_with(mark);
  execute("COMMIT");
  if (watch_) watch_->committed(mark);
}

void Database::roll_back() {
  // Where it fails SQLite does it by itself, when the connection is closed or the file is opened next.
  if (in_transaction()) sqlite3_exec(handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

bool Database::has_moved() const {
  int moved = 0;
  sqlite3_file_control(handle(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved != 0;
}

bool Database::is_in_place() const { return !has_moved() && (!watch_ || watch_->is_own()); }

void Database::check_in_place() {
  if (lost_.empty() && !is_in_place()) {
    const auto keep = has_moved() ? &keep_what_was_committed : &leave_what_was_copied_over;
    lost_ = keep(file_, handle(), place_.value_or(OpenPlace{}));
  }
  if (!lost_.empty()) throw Error(lost_);
  check_continued();
}

void Database::check_continued() {
  if (!watch_ || watch_->is_continued()) return;
  lost_ = leave_what_was_restored_over(file_);
  throw Error(lost_);
}

Transaction::Transaction(Database& database) : database_(database), outermost_(!database.in_transaction()) {
  if (!outermost_) return;
  database_.check_in_place();
  database_.begin();
}

Transaction::~Transaction() {
  if (open_ && outermost_) database_.roll_back();
}

void Transaction::commit() {
  if (!outermost_) {
    open_ = false;
    return;
  }
  if (!database_.is_in_place()) {
    database_.roll_back();
    database_.check_in_place();
  }
  database_.commit();
  open_ = false;
}

}  // namespace lacuna
