#pragma once

#include <lacuna/trial.h>

#include "eea/definition/eea_state.h"
#include "storage/eea/eea_records.h"
#include "storage/eea/failed_trials.h"

namespace lacuna {

/// Records the run of the algorithm. Rows come in the order of their numbers; a checkpoint says that all rows so far
/// led to this state.
class EeaJournal {
 public:
  virtual ~EeaJournal() = default;
  virtual void add(ModelRow row) = 0;
  virtual void add(TestRow row) = 0;
  virtual void add(TargetTrialRow row, const Trial& trial) = 0;
  /// The prediction of a trial by a model.
  virtual void add_prediction(std::uint64_t model, int trial, const TimeSeries& readings,
                              const TimeSeries& centre_of_mass) = 0;
  virtual void add(PassRow row) = 0;
  /// The target failed to carry out a test. Recorded at once; not among the rows that are compared between runs.
  virtual void note_failure(const FailedTrialRecord& failed) = 0;
  /// A sentence for the terminal.
  virtual void note(const std::string& /*sentence*/) {}
  /// At the end of each generation and phase. May be delayed unless `now`.
  virtual void checkpoint(const EeaState& state, bool now) = 0;
};

}  // namespace lacuna
