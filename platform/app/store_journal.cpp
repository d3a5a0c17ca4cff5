#include "app/store_journal.h"

#include "eea/recorded_trials.h"

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
  const std::vector<TargetTrialRow> rows = store.trial_rows();
  std::vector<Trial> trials = store.trials();
  state.trials.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TargetTrial& trial = state.trials[i];
    trial.trial = with_known_start(definition, std::move(trials[i]));
    const double end = trial.trial.measured.times(trial.trial.measured.times.size() - 1);
    trial.drive = rows[i].test
                      ? definition.drive_of(definition.decode_test(store.test(*rows[i].test)->genome), trial.trial)
                      : Test{trial.trial.commands, end, {}};
    trial.test = rows[i].test.value_or(0);
  }
  if (state.phase == Phase::estimation && !state.search.empty()) state.evaluated = store.models(state.pass);
  return state;
}

}  // namespace lacuna
