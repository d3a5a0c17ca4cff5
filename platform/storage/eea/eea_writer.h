#pragma once

#include "storage/integrity/row_key.h"
#include "storage/core/statement.h"
#include "storage/eea/eea_records.h"

#include <lacuna/trial.h>

#include <optional>
#include <vector>

namespace lacuna {

/// Inserts the rows of one run of the algorithm, in the caller's transaction. What others refer to comes first: tests,
/// trials, models, predictions, ends of passes; each in key order. Its statements are prepared once and kept.
/// After a transaction that was rolled back, make a new one. One thread at a time.
class EeaWriter {
 public:
  /// Reads what the run has already; throws `Error` if it was never begun. The database outlives it.
  EeaWriter(Database& database, RunId run, ExperimentId experiment);

  void insert(const TestRow& test);
  void insert(const TargetTrialRow& row, const Trial& trial);
  void insert(const ModelRow& model);
  void insert_prediction(std::uint64_t model, int trial, TraceKind kind, const TimeSeries& series);
  void insert(const PassRow& pass);

 private:
  void insert_ensemble(std::int64_t pass, const std::vector<EnsembleRow>& ensemble);
  std::int64_t pass_key(int number);
  std::optional<std::int64_t> key_of_some(std::optional<std::uint64_t> number) const;
  TrialId trial_of(int number) const;

  Database& database_;
  RunId run_;
  ExperimentId experiment_;
  std::int64_t metric_ = 0;
  std::optional<std::int64_t> fitness_;
  std::vector<TrialId> trials_;  ///< by number
  std::optional<int> pass_;      ///< that is known to have a row
  Statement insert_pass_;
  Statement insert_test_;
  Statement insert_test_score_;
  Statement insert_invalid_test_;
  Statement insert_model_;
  Statement insert_model_score_;
  Statement insert_invalid_model_;
};

}  // namespace lacuna
