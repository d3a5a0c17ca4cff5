#include "storage/queries/stored_tables.h"

#include "storage/core/statement.h"

namespace lacuna {
namespace {

std::vector<std::string> names_of_type(const Database& database, const char* type) {
  Statement row(
      database,
      "SELECT name FROM sqlite_master WHERE type = ? AND name NOT LIKE 'sqlite\\_%' ESCAPE '\\' ORDER BY name");
  row.with(type);
  std::vector<std::string> names;
  while (row.step()) names.push_back(row.text(0));
  return names;
}

}  // namespace

StoredTables stored_tables(const Database& database) {
  return {names_of_type(database, "view"), names_of_type(database, "table")};
}

void read_table(const Database& database, const std::string& name, QueryOutput& output) {
  run_queries(database, "SELECT * FROM " + name_in_sql(name), output);
}

}  // namespace lacuna
