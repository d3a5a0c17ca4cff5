#pragma once

#include "storage/database.h"
#include "storage/eea_records.h"
#include "storage/result_store.h"

#include <lacuna/time_series.h>

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// One run (one replicate) of the algorithm in a database. What is appended stays in memory until `commit`, which
/// writes it together with a checkpoint in one transaction: after a crash the database holds exactly what led to its
/// last checkpoint. Several stores may share a database and a mutex, one thread each.
class EeaStore {
 public:
  /// `run` was begun by a `ResultStore` on the same database.
  EeaStore(Database& database, std::mutex& writing, RunId run, ExperimentId experiment);
  ~EeaStore();

  void begin(const EeaRunRecord& record);
  void append(ModelRow row);
  void append(TestRow row);
  /// `measured`, `commands` and `centre_of_mass` are kept as they are (float64).
  void append(TargetTrialRow row, const Trial& trial);
  /// `predicted`: what the best model says about trial `first_trial`, `first_trial` + 1 ...; kept as float32.
  void append(PassRow row);
  void append_prediction(std::uint64_t model, int trial, const TimeSeries& readings, const TimeSeries& centre_of_mass);

  /// Writes all that was appended, and `checkpoint` in place of the last one.
  void commit(const CheckpointRow& checkpoint);
  void end(RunEnding ending);

  /// What there is to go on from; nothing where the run never committed a checkpoint.
  std::optional<CheckpointRow> checkpoint() const;
  std::vector<Trial> trials() const;  ///< measured, commands, centre of mass; by number
  std::vector<TargetTrialRow> trial_rows() const;
  std::vector<ModelRow> models(int pass) const;  ///< with their trial scores, by number
  std::optional<ModelRow> model(std::uint64_t number) const;
  std::optional<TestRow> test(std::uint64_t number) const;
  std::vector<PassRow> passes() const;
  EeaRunRecord record() const;
  /// Seconds spent in `commit` so far.
  double seconds() const;

 private:
  struct Pending;
  Database& database_;
  std::mutex& writing_;
  RunId run_;
  ExperimentId experiment_;
  std::unique_ptr<Pending> pending_;
};

/// SHA-256 over the content of a run: passes, tests, trials with their samples, models and scores, by key; not over
/// times, provenance, host or the run's number. Two runs with the same seed have the same hash.
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
  double seconds = kNotKnown;
};
std::vector<EeaRunListing> eea_runs(const Database& database);

}  // namespace lacuna
