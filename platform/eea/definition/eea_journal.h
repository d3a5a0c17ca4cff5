#pragma once

#include <lacuna/trial.h>

#include "eea/definition/eea_state.h"
#include "storage/eea/eea_records.h"
#include "storage/eea/failed_trials.h"

namespace lacuna {

/// Who writes down what the algorithm does. Rows come in the order of their numbers; a checkpoint says that everything
/// up to here led to this state.
class EeaJournal {
 public:
  virtual ~EeaJournal() = default;
  virtual void add(ModelRow row) = 0;
  virtual void add(TestRow row) = 0;
  virtual void add(TargetTrialRow row, const Trial& trial) = 0;
  /// What a model says about a trial.
  virtual void add_prediction(std::uint64_t model, int trial, const TimeSeries& readings,
                              const TimeSeries& centre_of_mass) = 0;
  virtual void add(PassRow row) = 0;
  /// The target did not carry a test out. Written down at once; no row that is compared with another run's.
  virtual void note_failure(const FailedTrialRecord& failed) = 0;
  /// A sentence for whoever watches.
  virtual void note(const std::string& /*sentence*/) {}
  /// At the end of each generation and phase. May be put off, but not if `now`.
  virtual void checkpoint(const EeaState& state, bool now) = 0;
};

}  // namespace lacuna
