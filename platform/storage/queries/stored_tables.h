#pragma once

#include "storage/queries/query.h"

#include <string>
#include <vector>

namespace lacuna {

/// Names of what a database has to be read whole, in alphabetical order; without SQLite's own tables.
struct StoredTables {
  std::vector<std::string> views, tables;
};
StoredTables stored_tables(const Database& database);

/// Hands all rows of a view or table to `output`, one after the other. Throws as `run_queries` does.
void read_table(const Database& database, const std::string& name, QueryOutput& output);

}  // namespace lacuna
