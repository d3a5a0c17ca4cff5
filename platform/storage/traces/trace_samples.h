#pragma once

#include "storage/core/database.h"

namespace lacuna {

/// While it lives, the samples of traces are readable as rows on this connection: a table-valued
/// function `trace_samples(trace)` with the columns sample, time, channel, value; one row a sample and
/// channel, NaN as NULL. `trace` is the key in table `trace`. The database outlives it.
class TraceSamples {
 public:
  explicit TraceSamples(const Database& database);
  ~TraceSamples();
  TraceSamples(const TraceSamples&) = delete;
  TraceSamples& operator=(const TraceSamples&) = delete;

 private:
  const Database& database_;
};

}  // namespace lacuna
