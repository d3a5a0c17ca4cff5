#include "app/runs/store_journal.h"

#include "storage/core/storage_error.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace lacuna {

void StoreJournal::checkpoint(const EeaState& state, bool now) {
  using namespace std::chrono_literals;
  const auto time = std::chrono::steady_clock::now();
  if (!now && state.phase != Phase::finished && time - last_ < 200ms) return;
  store_.commit({save(state)});
  last_ = std::chrono::steady_clock::now();
}

namespace {

/// The rows of a commit and its checkpoint are written together; a row more would be written over, or refused.
void check_follows(const EeaStore& store, const EeaState& state, std::size_t trials) {
  const auto missing = [](std::uint64_t numbered, const auto& row_of) {
    return row_of(numbered) || (numbered > 0 && !row_of(numbered - 1));
  };
  const char* const end = " do not match the checkpoint; restore a backup, or run again without --resume";
  if (state.trials.size() != trials)
    throw DamagedDatabase(fmt::format("its {} trials{}, which has {}", trials, end, state.trials.size()));
  if (missing(state.models, [&](std::uint64_t number) { return store.model(number).has_value(); }))
    throw DamagedDatabase(std::string("its models") + end);
  if (missing(state.tests, [&](std::uint64_t number) { return store.test(number).has_value(); }))
    throw DamagedDatabase(std::string("its tests") + end);
}

}  // namespace

std::optional<StoredState> read_checkpoint(const EeaStore& store) {
  const std::optional<CheckpointRow> checkpoint = store.checkpoint();
  if (!checkpoint) return std::nullopt;
  StoredState stored{load_state(checkpoint->state), stored_trials(store)};
  EeaState& state = stored.state;
  check_follows(store, state, stored.trials.size());
  if (state.phase == Phase::estimation && !state.search.empty()) state.evaluated = store.models(state.pass);
  return stored;
}

std::optional<EeaState> stored_state(const EeaStore& store, const EeaDefinition& definition) {
  std::optional<StoredState> stored = read_checkpoint(store);
  if (!stored) return std::nullopt;
  for (std::size_t i = 0; i < stored->trials.size(); ++i) {
    RunTrial trial = run_trial(definition, std::move(stored->trials[i]));
    TargetTrial& target = stored->state.trials[i];
    target.trial = std::move(trial.trial);
    target.drive = std::move(trial.drive);
    target.genome = std::move(trial.genome);
    target.test = trial.row.test.value_or(0);
  }
  return std::move(stored->state);
}

}  // namespace lacuna
