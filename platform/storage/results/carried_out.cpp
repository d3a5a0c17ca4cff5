#include "storage/results/carried_out.h"

#include "storage/core/canonical_text.h"
#include "storage/core/statement.h"
#include "storage/traces/trial_condition.h"
#include "storage/traces/write_trial.h"

namespace lacuna {
namespace {

/// Files of an older version, opened for reading, have no such table.
bool has_table(const Database& database) {
  Statement table(database, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'carried_out'");
  return table.step();
}

}  // namespace

std::int64_t count_carried_out(const Database& database, const std::string& experiment) {
  if (!has_table(database)) return 0;
  Statement count(database,
                  "SELECT count(*) FROM carried_out JOIN trial ON trial.id = carried_out.trial"
                  " JOIN experiment ON experiment.id = trial.experiment WHERE experiment.name = ?");
  count.with(experiment).step();
  return count.integer(0);
}

TrialId record_carried_out(const Database& database, RunId run, ExperimentId experiment, const Trial& trial,
                           const CarriedOutRecord& record) {
  const Eigen::VectorXd& times = trial.measured.times;
  const TrialId id = write_trial(database, run, experiment,
                                 {.name = trial.name,
                                  .file = "",
                                  .digest = digest_of(trial),
                                  .held_out = trial.held_out,
                                  .duration = times.size() > 0 ? times[times.size() - 1] - times[0] : 0.0,
                                  .samples = times.size()});
  write_trial_condition(database, id, trial);
  const auto keep = [&](TraceKind kind, const TimeSeries& series) {
    if (!series.channels.empty())
      write_trace(database, run, {.trial = id, .kind = kind}, series, TracePrecision::float64);
  };
  keep(TraceKind::measured, trial.measured);
  keep(TraceKind::commands, trial.commands.series);
  keep(TraceKind::centre_of_mass, trial.centre_of_mass);
  Statement(database, "INSERT INTO carried_out (trial, run, test, target) VALUES (?, ?, ?, ?)")
      .run_with(id, run, record.test, record.target);
  return id;
}

std::vector<Trial> carried_out_trials(const Database& database, const std::string& experiment,
                                      const std::string& target) {
  std::vector<Trial> trials;
  if (!has_table(database)) return trials;
  Statement row(database,
                "SELECT carried_out.trial FROM carried_out JOIN trial ON trial.id = carried_out.trial"
                " JOIN experiment ON experiment.id = trial.experiment"
                " WHERE experiment.name = ? AND carried_out.target = ? ORDER BY carried_out.run, carried_out.trial");
  row.with(experiment, target);
  while (row.step()) trials.push_back(read_trial(database, {row.integer(0)}));
  return trials;
}

}  // namespace lacuna
