#include "storage/core/work_time.h"

#include "storage/core/statement.h"

#include <cmath>

namespace lacuna {

void record_seconds(const Database& database, const char* kind, std::int64_t id, double seconds) {
  if (std::isnan(seconds)) return;
  Statement(database, "INSERT INTO work_time (kind, id, seconds) VALUES (?, ?, ?)").run_with(kind, id, seconds);
}

double seconds_of(const Database& database, const char* kind, std::int64_t id) {
  Statement row(database, "SELECT seconds FROM work_time WHERE kind = ? AND id = ?");
  return row.with(kind, id).step() ? row.real(0) : kNotKnown;
}

}  // namespace lacuna
