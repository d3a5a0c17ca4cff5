#pragma once

#include "app/runs/run_trials.h"
#include "eea/definition/eea_definition.h"
#include "eea/definition/eea_journal.h"
#include "storage/eea/eea_store.h"

#include <chrono>
#include <optional>
#include <vector>

namespace lacuna {

/// Writes a run into its database, at most every 0.2 s: what a crash can lose.
class StoreJournal : public EeaJournal {
 public:
  explicit StoreJournal(EeaStore& store) : store_(store) {}

  void add(ModelRow row) override { store_.append(std::move(row)); }
  void add(TestRow row) override { store_.append(std::move(row)); }
  void add(TargetTrialRow row, const Trial& trial) override { store_.append(std::move(row), trial); }
  void add_prediction(std::uint64_t model, int trial, const TimeSeries& readings,
                      const TimeSeries& centre_of_mass) override {
    store_.append_prediction(model, trial, readings, centre_of_mass);
  }
  void add(PassRow row) override { store_.append(std::move(row)); }
  void note_failure(const FailedTrialRecord& failed) override { store_.note_failure(failed); }
  void checkpoint(const EeaState& state, bool now) override;

 private:
  EeaStore& store_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What a run's last checkpoint leaves as it is stored, without what its experiment and plugins make of the trials;
/// the models of its pass are in the state.
struct StoredState {
  EeaState state;
  std::vector<KeptTrial> trials;
};

/// Nothing where there is none. Throws `Error` where it cannot be read, and where rows of the run do not follow from
/// it.
std::optional<StoredState> read_checkpoint(const EeaStore& store);

/// The state that a run's last checkpoint leaves, with its trials and the models of its pass; nothing where it has
/// none.
std::optional<EeaState> stored_state(const EeaStore& store, const EeaDefinition& definition);

}  // namespace lacuna
