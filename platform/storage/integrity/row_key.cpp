#include "storage/integrity/row_key.h"

namespace lacuna {

std::int64_t next_key(const Database& database, const char* table, RunId run) {
  const std::string sql = std::string("SELECT coalesce(max(id), ?1) + 1 FROM ") + table + " WHERE id BETWEEN ?1 AND ?2";
  Statement statement(database, sql.c_str());
  statement.with(key_base(run), last_key(run)).step();
  return statement.integer(0);
}

}  // namespace lacuna
