#include "storage/traces/trace_samples_module.h"

#include <sqlite3ext.h>

SQLITE_EXTENSION_INIT1

/// Loaded into any program with SQLite, such as `sqlite3 rig.db -cmd ".load /path/to/lacuna_sqlite"`: the samples of
/// stored traces as rows, `trace_samples(trace)`. SQLite finds the function by its name, which it makes from the
/// file's.
extern "C" [[gnu::visibility("default")]] int sqlite3_lacunasqlite_init(sqlite3* handle, char**,
                                                                        const sqlite3_api_routines* api) {
  SQLITE_EXTENSION_INIT2(api);
  return lacuna::add_trace_samples(handle);
}
