#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// Proof that what a run stored is still what it ended with: of each table that has rows of the run, the SHA-256 of
/// these rows, every column with its type and its bits. It shows accidents; who changes rows on purpose can change it.

/// Writes the seals of runs, in the place of those that they had. To be called in the transaction that ends a run,
/// after everything else that it writes.
class Sealer {
 public:
  explicit Sealer(Database& database);
  ~Sealer();
  Sealer(const Sealer&) = delete;
  Sealer& operator=(const Sealer&) = delete;

  void seal(RunId run);

 private:
  struct Part;
  Database& database_;
  std::vector<std::unique_ptr<Part>> parts_;  ///< one for each table
};
/// Of one; of many, one `Sealer` is much faster.
void seal_run(Database& database, RunId run);
/// Removes them, because the run continues.
void unseal_run(Database& database, RunId run);

/// Rows of a run in one table that are not those of its seal.
struct BrokenSeal {
  RunId run;
  std::string table;
  std::string reason;  ///< "3 rows instead of 4", "different content", why it cannot be read
};

struct SealCheck {
  std::vector<RunId> sealed;
  std::vector<RunId> not_ended;       ///< not covered
  std::vector<RunId> ended_unsealed;  ///< by a version that made no seals: not covered
  std::vector<BrokenSeal> broken;
};

/// Hashes all rows of sealed runs again. `progress` gets the part that is done, 0 to 1.
SealCheck check_seals(const Database& database, const std::function<void(double)>& progress = {});

/// The tables whose rows are sealed, for the test that none is forgotten.
std::vector<std::string> sealed_tables();

}  // namespace lacuna
