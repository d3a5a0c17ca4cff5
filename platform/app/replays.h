#pragma once

#include "app/stored_bench.h"
#include "storage/page_database.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace lacuna {

/// Has trials of stored runs carried out again by the robots of the target and of the best model, and keeps how they
/// moved for the pages. Several threads may ask.
class Replays {
 public:
  /// `pages` must live as long.
  Replays(std::filesystem::path database, std::vector<std::filesystem::path> plugin_paths, PageDatabase& pages);

  /// Trial `trial` of a run, by the best model of the last pass that has ended, unless that is there. Throws `Error`,
  /// `BadInput` where it cannot be simulated.
  void prepare(std::int64_t run, std::int64_t trial);

  /// Trials of all runs, the newest first, as many as a report has room for; notes say which robots are missing.
  void prepare_for_report(std::size_t most_bytes);

 private:
  const StoredBench& bench_of(const Database& database, const EeaRunListing& run);
  void simulate(const Database& database, const EeaRunListing& run, std::int64_t trial);

  std::filesystem::path database_;
  std::vector<std::filesystem::path> plugin_paths_;
  PageDatabase& pages_;
  std::mutex working_;
  std::map<std::int64_t, StoredBench> benches_;  ///< by run
};

}  // namespace lacuna
