#include "storage/database.h"

#include "foundation/problem.h"
#include "storage/migrate.h"
#include "storage/storage_error.h"

#include <lacuna/error.h>

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>
#include <unistd.h>

#include <thread>

namespace lacuna {
namespace {

constexpr int kBusyTimeoutMs = 5000;  ///< another writer's transaction takes milliseconds
constexpr int kPauseMs = 5;

std::unique_ptr<SQLite::Database> connect(const std::filesystem::path& file, const std::string& name, int flags) {
  if (std::filesystem::is_directory(file)) {
    throw_problem({file.string()}, "is a folder; name a database file");
  }
  if (const std::filesystem::path folder = file.parent_path(); !folder.empty() && !std::filesystem::exists(folder))
    throw_problem({file.string()}, "cannot be opened: there is no folder " + folder.string());
  try {
    auto connection = std::make_unique<SQLite::Database>(name, flags | SQLITE_OPEN_EXRESCODE, kBusyTimeoutMs);
    connection->exec("PRAGMA foreign_keys = ON");
    return connection;
  } catch (const SQLite::Exception& error) {
    throw_storage_error(file, error);
  }
}

bool has_content(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(file, ignored);
  return !ignored && size > 0;
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
    throw Error(file.string() + ": cannot keep a write-ahead log in this folder; use --db with a file on a local disk");
  }
}

/// A URI that SQLite takes for this file, whatever characters its name has.
std::string uri_of(const std::filesystem::path& file) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '?' || c == '#' || c == '%') {
      static constexpr char kDigits[] = "0123456789ABCDEF";
      uri += {'%', kDigits[static_cast<unsigned char>(c) >> 4U], kDigits[static_cast<unsigned char>(c) & 15U]};
    } else {
      uri += c;
    }
  }
  return uri;
}

}  // namespace

Database::Database(std::filesystem::path file) : file_(std::move(file)) {}
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

Database Database::open(const std::filesystem::path& file, const std::vector<Migration>& migrations) {
  Database database(file);
  database.connection_ = connect(file, file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (sqlite3_db_readonly(database.handle(), "main") == 1) throw_storage_error(file, SQLITE_READONLY, "");
  check_header(database, migrations);
  // Only now may anything be written to it: it is ours, or empty.
  keep_write_ahead_log(file, database.handle());
  database.execute("PRAGMA synchronous = FULL");
  database.identity_ = identity_of(file);
  migrate(database, migrations);
  return database;
}

Database Database::open(const std::filesystem::path& file) {
  Database database = open(file, schema_migrations());
  refresh_views(database, schema_views());
  return database;
}

void Database::read_copy_of_this_version() {
  // SQLite keeps a database without a name in a temporary file that ends with the connection.
  std::unique_ptr<SQLite::Database> copy = connect(file_, "", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  try {
    SQLite::Backup(*copy, *connection_).executeStep();
  } catch (const SQLite::Exception& error) {
    throw_storage_error(file_, error);
  }
  connection_ = std::move(copy);
  bring_up_to_date(*this, schema_migrations());
  refresh_views(*this, schema_views());
}

Database Database::open_read_only(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    throw_problem({file.string()},
                  "no such database; `lacuna compare` and `lacuna run` make one from an experiment file");
  }
  Database database(file);
  database.connection_ = connect(file, file.string(), SQLITE_OPEN_READONLY);
  try {
    check_header(database, schema_migrations());
  } catch (const Error&) {
    // On read-only media the write-ahead log's index cannot be made. Without a log none is needed.
    const bool cannot_open = (sqlite3_errcode(database.handle()) & 0xff) == SQLITE_CANTOPEN ||
                             (sqlite3_errcode(database.handle()) & 0xff) == SQLITE_READONLY;
    if (!cannot_open) throw;
    if (has_content(file.string() + "-wal")) {
      throw Error(file.string() +
                  ": has changes in its -wal file, which cannot be read in a read-only folder; copy both files to a "
                  "folder that can be written, and read them there");
    }
    database.connection_ = connect(file, uri_of(file) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    check_header(database, schema_migrations());
  }
  if (!is_of_version(database, schema_migrations())) database.read_copy_of_this_version();
  database.execute("PRAGMA query_only = ON");
  return database;
}

Database Database::open_copy(const std::filesystem::path& file) {
  Database database = open_read_only(file);
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

bool Database::has_moved() const {
  int moved = 0;
  sqlite3_file_control(handle(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved != 0;
}

void Database::check_not_moved() {
  if (lost_.empty() && has_moved()) {
    lost_ = keep_what_was_committed(file_, handle(), identity_.value_or(FileIdentity{}));
  }
  if (!lost_.empty()) throw Error(lost_);
}

Transaction::Transaction(Database& database) : database_(database), outermost_(!database.in_transaction()) {
  if (!outermost_) return;
  database_.check_not_moved();
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!open_ || !outermost_ || !database_.in_transaction()) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const Error&) {
    // SQLite rolls back by itself when the connection is closed or the file is opened next.
  }
}

void Transaction::commit() {
  if (!outermost_) {
    open_ = false;
    return;
  }
  if (database_.has_moved()) {
    database_.execute("ROLLBACK");
    database_.check_not_moved();
  }
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace lacuna
