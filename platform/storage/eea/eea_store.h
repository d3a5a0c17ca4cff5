#pragma once

#include "storage/core/database.h"
#include "storage/eea/eea_records.h"
#include "storage/eea/failed_trials.h"
#include "storage/results/result_store.h"

#include <lacuna/trial.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

class EeaWriter;

/// One run (one replicate) of the algorithm in a database. What is appended stays in memory until `commit`, which
/// writes it together with a checkpoint in one transaction: after a crash the database holds exactly what led to its
/// last checkpoint. A commit that fails changes nothing, and what was appended is still there for the next one.
/// Several stores may share a database and a mutex, one thread each; no member may be called while the mutex is held.
/// Numbers come back with the same bits, but a NaN as `kNotKnown` and, outside of genomes and checkpoints, −0.0 as 0.0.
/// A store that only reads may have a database that was opened for reading. All members throw `Error` with a sentence.
class EeaStore {
 public:
  /// `run` was begun, or is continued, by a `ResultStore` on the same database, which need not live on: whatever ending
  /// it left is taken back by the first thing that is written here.
  EeaStore(Database& database, std::mutex& writing, RunId run, ExperimentId experiment);
  /// A run that was written to and not ended is stored as failed.
  ~EeaStore();
  EeaStore(const EeaStore&) = delete;
  EeaStore& operator=(const EeaStore&) = delete;

  /// Stores the settings of the run at once. For a run that has begun before, checks that they are the same.
  void begin(const EeaRunRecord& record);
  /// From now on another store ends the run.
  void hand_over() { to_end_ = false; }
  void append(ModelRow row);
  void append(TestRow row);
  /// `measured`, `commands` and `centre_of_mass` are kept as they are (float64). Trials come in the order of their
  /// numbers.
  void append(TargetTrialRow row, const Trial& trial);
  void append(PassRow row);
  /// What a model says about one trial; kept as float32. `centre_of_mass` may be empty.
  void append_prediction(std::uint64_t model, int trial, const TimeSeries& readings, const TimeSeries& centre_of_mass);

  /// Writes at once that the target did not carry a test out, apart from what was appended.
  void note_failure(const FailedTrialRecord& failed);

  /// Writes all that was appended, and `checkpoint` in place of the last one.
  void commit(const CheckpointRow& checkpoint);
  /// Rows appended since the last commit are dropped; if `done`, there must be none.
  void end(RunEnding ending);

  /// The checkpoint to continue from; empty if the run never committed one.
  std::optional<CheckpointRow> checkpoint() const;
  std::vector<Trial> trials() const;  ///< measured, commands, centre of mass; by number
  std::vector<TargetTrialRow> trial_rows() const;
  std::vector<ModelRow> models(int pass) const;  ///< with their trial scores, by number
  std::optional<ModelRow> model(std::uint64_t number) const;
  std::optional<TestRow> test(std::uint64_t number) const;
  /// The path of the centre of mass that a model predicts for a trial, where it was kept.
  std::optional<TimeSeries> predicted_path(std::uint64_t model, int trial) const;
  std::vector<PassRow> passes() const;  ///< that have ended
  EeaRunRecord record() const;
  /// Seconds spent in `commit` since this store was made, waiting for other writers included.
  double seconds() const;
  /// Seconds of work on the run until now: since this store was made, and of earlier ones until their last commit.
  double work_seconds() const;

 private:
  struct Pending;
  bool is_taken_over() const;
  void write(const CheckpointRow& checkpoint);
  void write_checkpoint(const CheckpointRow& checkpoint);

  Database& database_;
  std::mutex& writing_;
  RunId run_;
  ExperimentId experiment_;
  std::unique_ptr<Pending> pending_;
  std::unique_ptr<EeaWriter> writer_;              ///< made at the first commit, and after one that failed
  mutable std::optional<std::int64_t> commits_;    ///< that the run had when last looked at
  mutable std::optional<double> earlier_seconds_;  ///< of work, before this store was made
  std::chrono::steady_clock::time_point made_;
  double seconds_ = 0.0;
  bool to_end_ = false;  ///< was written to and not ended
};

/// SHA-256 over the content of a run: what it is about, passes, tests, trials with their samples, models and scores, by
/// key within the run; not over its number, names that carry it, reasons of invalid rows, times, provenance, host or
/// checkpoint. Two runs with
/// the same seed have the same hash. Throws `Error` if the run is not one of the algorithm.
std::string content_hash(const Database& database, RunId run);

/// Of all finished or unfinished runs of the algorithm in a database, by number.
struct EeaRunListing {
  RunId run;
  int replicate = 1;
  std::string experiment;
  std::string ending;  ///< "done", "failed", "interrupted", "not ended"
  int passes_done = 0, passes = 0;
  std::optional<double> best_score;
  std::uint64_t models = 0, evaluations = 0;
  double seconds = kNotKnown;  ///< of work until the last commit, over all its continuations
  std::string stopped = {};    ///< why it ended before its last pass; empty: it did not
  std::string identity = {};   ///< that no other run has, whatever file it is in
};
/// Empty for a file that an older version wrote.
std::vector<EeaRunListing> eea_runs(const Database& database);

}  // namespace lacuna
