#include "storage/files/log_left.h"

#include "storage/files/connection.h"
#include "storage/files/foreign_log.h"

#include <SQLiteCpp/Database.h>
#include <sqlite3.h>

namespace lacuna {
namespace {

std::filesystem::path log_of(const std::filesystem::path& database) { return beside(database, "-wal"); }

bool is_empty_file(const std::filesystem::path& file) {
  std::error_code missing;
  return std::filesystem::file_size(file, missing) == 0 && !missing;
}

}  // namespace

LogLeft::LogLeft(const std::filesystem::path& database)
    : database_(database), was_there_(std::filesystem::exists(log_of(database))) {}

LogLeft::~LogLeft() {
  if (was_there_) return;
  try {
    if (!is_empty_file(log_of(database_))) return;
    open_connection(database_.string(), SQLITE_OPEN_READWRITE)
        ->exec("SELECT count(*) FROM sqlite_master");  // which opens the log
  } catch (const std::exception&) {
    // The files stay, and harm nobody.
  }
}

}  // namespace lacuna
