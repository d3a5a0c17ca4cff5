#include "storage/log_left.h"

#include <sqlite3.h>

namespace lacuna {
namespace {

std::filesystem::path log_of(const std::filesystem::path& database) { return database.string() + "-wal"; }

bool is_empty_file(const std::filesystem::path& file) {
  std::error_code missing;
  return std::filesystem::file_size(file, missing) == 0 && !missing;
}

}  // namespace

LogLeft::LogLeft(const std::filesystem::path& database)
    : database_(database), was_there_(std::filesystem::exists(log_of(database))) {}

LogLeft::~LogLeft() {
  if (was_there_ || !is_empty_file(log_of(database_))) return;
  sqlite3* handle = nullptr;
  if (sqlite3_open_v2(database_.c_str(), &handle, SQLITE_OPEN_READWRITE, nullptr) == SQLITE_OK)
    sqlite3_exec(handle, "SELECT count(*) FROM sqlite_master", nullptr, nullptr, nullptr);  // which opens the log
  sqlite3_close(handle);
}

}  // namespace lacuna
