#include "app/tasks/new_database.h"

#include "foundation/processes/interrupt.h"
#include "storage/core/statement.h"
#include "storage/files/log_left.h"

namespace lacuna {
namespace {

bool has_runs(const std::filesystem::path& file) {
  const LogLeft log(file);
  const Database database = Database::open_read_only(file, when_interrupted());
  return Statement(database, "SELECT 1 FROM run").step();
}

}  // namespace

NewDatabase::NewDatabase(const std::filesystem::path& file) : file_(file), was_there_(std::filesystem::exists(file)) {}

NewDatabase::~NewDatabase() {
  try {
    if (!was_there_ && std::filesystem::exists(file_) && !has_runs(file_)) std::filesystem::remove(file_);
  } catch (const std::exception&) {
    // It stays.
  }
}

}  // namespace lacuna
