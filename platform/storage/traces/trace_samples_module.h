#pragma once

struct sqlite3;

/// The table-valued function of trace_samples.h for a connection of SQLite, the program's own or, in the loadable
/// extension lacuna_sqlite.cpp, another program's.
namespace lacuna {

/// Returns a result code of SQLite.
int add_trace_samples(sqlite3* handle);
int remove_trace_samples(sqlite3* handle);

}  // namespace lacuna
