#include "app/runs/run_trials.h"

#include "eea/trials/recorded_trials.h"
#include "storage/core/storage_error.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace lacuna {

ScoredTrial as_new_trial(const RunTrial& trial) { return {trial.drive, trial.trial, 0}; }

std::vector<KeptTrial> stored_trials(const EeaStore& store) {
  std::vector<TargetTrialRow> rows = store.trial_rows();
  std::vector<Trial> trials = store.trials();
  if (rows.size() != trials.size()) throw DamagedDatabase("trials that the run carried out are missing");
  std::vector<KeptTrial> stored;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string name = fmt::format("trial {}", rows[i].number);
    if (rows[i].number != static_cast<int>(i)) throw DamagedDatabase(name + " is out of order");
    if (trials[i].measured.times.size() == 0) throw DamagedDatabase(name + " has no readings");
    Genome genome;
    if (rows[i].test) {
      std::optional<TestRow> test = store.test(*rows[i].test);
      if (!test) throw DamagedDatabase(fmt::format("{} carried out test {}, which is missing", name, *rows[i].test));
      genome = std::move(test->genome);
    }
    stored.push_back({std::move(rows[i]), std::move(genome), std::move(trials[i])});
  }
  return stored;
}

RunTrial run_trial(const EeaDefinition& definition, KeptTrial stored) {
  Trial& trial = stored.trial;
  const double end = trial.measured.times(trial.measured.times.size() - 1);
  Test drive = stored.row.test ? definition.drive_of(definition.decode_test(stored.genome), trial)
                               : Test{trial.commands, end, {}, trial.setup.name};
  return {std::move(stored.row), std::move(drive), std::move(stored.genome),
          with_known_start(definition, std::move(trial))};
}

std::vector<RunTrial> run_trials(const EeaStore& store, const EeaDefinition& definition) {
  std::vector<RunTrial> trials;
  for (KeptTrial& stored : stored_trials(store)) trials.push_back(run_trial(definition, std::move(stored)));
  return trials;
}

}  // namespace lacuna
