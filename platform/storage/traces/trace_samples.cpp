#include "storage/traces/trace_samples.h"

#include "storage/core/storage_error.h"
#include "storage/traces/trace_samples_module.h"

#include <sqlite3.h>

namespace lacuna {

TraceSamples::TraceSamples(const Database& database) : database_(database) {
  const int result = add_trace_samples(database.handle());
  if (result != SQLITE_OK) throw_storage_error(database.file(), result, sqlite3_errmsg(database.handle()));
}

TraceSamples::~TraceSamples() { remove_trace_samples(database_.handle()); }

}  // namespace lacuna
