#pragma once

#include "app/runs/run_trials.h"
#include "eea/ensemble/ensemble_prediction.h"

#include <vector>

namespace lacuna {

/// The models of a stored run that agree, or do not, pass by pass.
class StoredEnsembles {
 public:
  /// Definition and trials must outlive it.
  StoredEnsembles(const EeaStore& store, const EeaDefinition& definition, const std::vector<RunTrial>& trials,
                  const Stop& stop = {});

  /// Empty: of a run whose models were not kept, for an older version made it.
  bool empty() const { return passes_.empty() || passes_.back().row.ensemble.empty(); }
  /// Of the last pass that has ended, with the noise of a reading.
  PassEnsemble newest() const { return with_noise(passes_.back()); }
  /// Whether the newest models were fitted to the trial.
  bool fitted(const RunTrial& trial) const { return counts(trial, passes_.back().row); }
  /// Each trial that was carried out after a pass, as that pass's models predict it. Does not depend on
  /// `threads`.
  std::vector<HeldOutTrial> held_out(int threads) const;

 private:
  struct Pass {
    PassRow row;
    PassEnsemble ensemble;  ///< without noise
  };
  static bool counts(const RunTrial& trial, const PassRow& pass);
  PassEnsemble with_noise(const Pass& pass) const;

  const EeaDefinition& definition_;
  const std::vector<RunTrial>& trials_;
  std::vector<Pass> passes_;
  Stop stop_;
};

}  // namespace lacuna
