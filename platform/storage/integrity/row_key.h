#pragma once

#include "storage/core/statement.h"

namespace lacuna {

/// A row of a run is numbered run number × 2^40 + counter; the counter begins at 1.
inline constexpr int kCounterBits = 40;

/// Before a run's first row.
inline std::int64_t key_base(RunId run) { return run.value << kCounterBits; }
/// The largest key that a run's row can have.
inline std::int64_t last_key(RunId run) { return key_base(run) + ((std::int64_t{1} << kCounterBits) - 1); }

/// The key of what is numbered from 0 within its run.
inline std::int64_t key_of(RunId run, std::uint64_t number) {
  return key_base(run) + 1 + static_cast<std::int64_t>(number);
}
/// The run whose row it is.
inline RunId run_of(std::int64_t key) { return {key >> kCounterBits}; }
inline std::uint64_t number_of(std::int64_t key) {
  return static_cast<std::uint64_t>(key & ((std::int64_t{1} << kCounterBits) - 1)) - 1;
}

/// The key after the last row that the run has in a table.
std::int64_t next_key(const Database& database, const char* table, RunId run);

}  // namespace lacuna
