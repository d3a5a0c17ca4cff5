#pragma once

#include "foundation/processes/stop.h"

#include <memory>
#include <string>

struct sqlite3;
namespace SQLite {
class Database;
}

namespace lacuna {

inline constexpr int kBusyTimeoutMs = 5000;  ///< another writer's transaction takes milliseconds

/// Opens a database such that nothing in the file can do more than hold data: every connection of the program is opened
/// here. Of functions and table modules there are only those of SQLite's core and JSON, of which none that reaches out
/// of the file runs in views, checks and columns; triggers do not run, extensions cannot be loaded, and statements
/// cannot damage the file (SQLITE_DBCONFIG_DEFENSIVE). Foreign keys are enforced. Nothing of the file is read yet.
/// Throws `SQLite::Exception`.
std::unique_ptr<SQLite::Database> open_connection(const std::string& name, int flags);

/// From now on long questions end when `stop` is due, which must live as long as the connection.
void end_when_due(SQLite::Database& connection, const Stop& stop);

/// A URI that SQLite takes for this file, whatever characters its name has.
std::string uri_of(const std::string& file);

}  // namespace lacuna
