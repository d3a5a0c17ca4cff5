#pragma once

#include "app/runs/run_trials.h"
#include "app/runs/open_stored_run.h"
#include "app/runs/stored_model.h"
#include "storage/pages/page_database.h"

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
  Replays(std::filesystem::path database, std::vector<std::filesystem::path> plugin_paths, PageDatabase& pages,
          const Stop& stop = {});

  /// Trial `trial` of a run, by the best model of the last pass that has ended, unless that is there: also a trial that
  /// the model was not fitted to, as the last one, which tells how well it predicts. Returns its key in the pages.
  /// Throws `Error`, `BadInput` where it cannot be simulated.
  std::int64_t prepare(std::int64_t run, std::int64_t trial);

  /// Trials of all runs, the newest first, as many as a report has room for; notes say which robots are missing.
  void prepare_for_report(std::size_t most_bytes);

 private:
  /// The best model of a run so far, and what it is simulated with.
  struct Subject {
    const OpenStoredRun& stored;
    EeaRunListing run;
    int pass = 0;
    StoredModel model;
    std::vector<RunTrial> trials;  ///< all of the run
  };
  const OpenStoredRun& bench_of(const Database& database, const EeaRunListing& run);
  static ScoredTrial trial_of(const Subject& subject, std::int64_t trial);
  Subject subject_of(Database& database, const EeaRunListing& run);
  std::int64_t find_or_simulate(const Subject& subject, std::int64_t trial);
  ReplayRecord simulate(const Subject& subject, std::int64_t trial) const;
  /// Returns how many trials, of those that could be simulated.
  std::size_t prepare_run(const Subject& subject, std::size_t most_trials, std::size_t most_bytes);

  std::filesystem::path database_;
  std::vector<std::filesystem::path> plugin_paths_;
  const Stop stop_;
  PageDatabase& pages_;
  std::mutex working_;
  std::map<std::string, OpenStoredRun> benches_;  ///< by the identities of runs
};

}  // namespace lacuna
