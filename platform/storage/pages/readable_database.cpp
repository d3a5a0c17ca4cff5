#include "storage/pages/readable_database.h"

#include "storage/core/database.h"
#include "storage/core/storage_error.h"
#include "storage/files/connection.h"
#include "storage/queries/page_query.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>
#include <sqlite3.h>

namespace lacuna {
namespace {

/// Of an older version's file a copy without a name is open.
bool is_temporary(const Database& database) {
  const char* const name = sqlite3_db_filename(database.handle(), "main");
  return name == nullptr || *name == '\0';
}

void write_copy(const Database& database, const std::filesystem::path& copy) {
  try {
    const auto into = open_connection(copy.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    SQLite::Backup(*into, database.connection()).executeStep();
  } catch (const SQLite::Exception& error) {
    throw_storage_error(copy, error);
  }
}

void remove_copy(const std::filesystem::path* copy) {
  std::error_code ignored;
  for (const char* tail : {"", "-wal", "-shm"}) std::filesystem::remove(copy->string() + tail, ignored);
  delete copy;
}

}  // namespace

ReadableDatabase::ReadableDatabase(std::filesystem::path database, std::filesystem::path scratch, const Stop& stop)
    : database_(std::move(database)), scratch_(std::move(scratch)), stop_(stop) {}

std::shared_ptr<const std::filesystem::path> ReadableDatabase::file() {
  const std::lock_guard lock(looking_);
  const std::string stamp = stamp_of(database_);
  if (!file_ || stamp != stamp_) {
    file_ = find();
    stamp_ = stamp;
  }
  return file_;
}

std::shared_ptr<const std::filesystem::path> ReadableDatabase::find() {
  const Database database = Database::open_read_only(database_, stop_);
  if (!is_temporary(database)) return std::make_shared<const std::filesystem::path>(database_);
  const std::filesystem::path copy = scratch_ / fmt::format("version-{}.db", ++copies_);
  write_copy(database, copy);
  return {new std::filesystem::path(copy), &remove_copy};
}

}  // namespace lacuna
