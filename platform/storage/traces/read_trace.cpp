#include "storage/traces/read_trace.h"

#include "storage/core/statement.h"
#include "storage/traces/trace_codec.h"

#include <lacuna/error.h>

namespace lacuna {

TimeSeries read_trace(const Database& database, TraceId trace) {
  Statement row(database, "SELECT channels, sample_count, precision, times, samples, digest FROM trace WHERE id = ?");
  if (!row.with(trace).step()) throw Error(database.file().string() + ": has no trace " + std::to_string(trace.value));
  return decode_trace({.channels = row.text(0),
                       .sample_count = row.integer(1),
                       .precision = row.text(2) == "float32" ? TracePrecision::float32 : TracePrecision::float64,
                       .times = row.bytes(3),
                       .samples = row.bytes(4),
                       .digest = row.text(5)});
}

}  // namespace lacuna
