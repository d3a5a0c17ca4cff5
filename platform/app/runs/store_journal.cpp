#include "app/runs/store_journal.h"

#include "app/runs/run_trials.h"

#include <utility>

namespace lacuna {

void StoreJournal::checkpoint(const EeaState& state, bool now) {
  using namespace std::chrono_literals;
  const auto time = std::chrono::steady_clock::now();
  if (!now && state.phase != Phase::finished && time - last_ < 200ms) return;
  store_.commit({save(state)});
  last_ = std::chrono::steady_clock::now();
}

std::optional<EeaState> stored_state(const EeaStore& store, const EeaDefinition& definition) {
  const std::optional<CheckpointRow> checkpoint = store.checkpoint();
  if (!checkpoint) return std::nullopt;
  EeaState state = load_state(checkpoint->state);
  std::vector<RunTrial> stored = run_trials(store, definition);
  state.trials.resize(stored.size());
  for (std::size_t i = 0; i < stored.size(); ++i) {
    state.trials[i].trial = std::move(stored[i].trial);
    state.trials[i].drive = std::move(stored[i].drive);
    state.trials[i].genome = std::move(stored[i].genome);
    state.trials[i].test = stored[i].row.test.value_or(0);
  }
  if (state.phase == Phase::estimation && !state.search.empty()) state.evaluated = store.models(state.pass);
  return state;
}

}  // namespace lacuna
