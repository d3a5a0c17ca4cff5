#include "app/runs/run_trials.h"

#include "eea/recorded_trials.h"

#include <utility>

namespace lacuna {

ScoredTrial as_foretold(const RunTrial& trial) { return {trial.drive, trial.trial, 0}; }

std::vector<RunTrial> run_trials(const EeaStore& store, const EeaDefinition& definition) {
  std::vector<TargetTrialRow> rows = store.trial_rows();
  std::vector<Trial> trials = store.trials();
  std::vector<RunTrial> stored;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double end = trials[i].measured.times(trials[i].measured.times.size() - 1);
    Genome genome = rows[i].test ? store.test(*rows[i].test)->genome : Genome();
    Test drive = rows[i].test ? definition.drive_of(definition.decode_test(genome), trials[i])
                              : Test{trials[i].commands, end, {}, trials[i].setup.name};
    stored.push_back(
        {std::move(rows[i]), std::move(drive), std::move(genome), with_known_start(definition, std::move(trials[i]))});
  }
  return stored;
}

}  // namespace lacuna
