#pragma once

#include "foundation/processes/stop.h"
#include "storage/integrity/run_rows.h"
#include "storage/core/statement.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// How many rows, and the SHA-256 of every column's type and bits.
struct HashedRows {
  std::int64_t rows = 0;
  std::string sha256;  ///< empty where there are no rows
  bool operator==(const HashedRows&) const = default;
};

/// Hashes what runs have in one table.
class RowHash {
 public:
  /// `columns`: those that were there when the run ended; later versions may have more. `key`: orders the rows.
  RowHash(const Database& database, const TableOfRuns& table, const std::vector<std::string>& columns,
          const std::vector<std::string>& key);

  /// Throws `Interrupted` where a request of `stop` was made.
  HashedRows of(RunId run, const Stop& stop);

 private:
  RowOwner owner_;
  Statement row_;
};

}  // namespace lacuna
