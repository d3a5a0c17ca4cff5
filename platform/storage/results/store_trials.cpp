#include "storage/results/result_store.h"

#include "storage/core/names.h"
#include "storage/core/statement.h"
#include "storage/traces/read_trace.h"
#include "storage/traces/write_trial.h"

#include <lacuna/error.h>

namespace lacuna {

TrialId ResultStore::find_or_add_trial(ExperimentId experiment, const TrialRecord& record) {
  Transaction transaction(database_);
  const TrialId trial = write_trial(database_, run(), experiment, record);
  transaction.commit();
  return trial;
}

std::vector<StoredTrial> ResultStore::trials(ExperimentId experiment) const {
  Statement row(
      database_,
      "SELECT id, name, file, digest, held_out, duration, samples, setup FROM trial WHERE experiment = ? ORDER BY id");
  row.with(experiment);
  std::vector<StoredTrial> trials;
  while (row.step()) {
    trials.push_back({{row.integer(0)},
                      {.name = row.text(1),
                       .file = row.text(2),
                       .digest = row.text(3),
                       .held_out = row.flag(4),
                       .duration = row.real(5),
                       .samples = row.integer(6),
                       .setup = {row.text(7), read_settings(database_, {row.integer(0)})}}});
  }
  return trials;
}

TraceId ResultStore::record_trace(TrialId trial, TraceKind kind, const TimeSeries& series, TracePrecision precision,
                                  std::optional<ComparisonId> comparison) {
  Transaction transaction(database_);
  const TraceId id =
      write_trace(database_, run(), {.trial = trial, .comparison = comparison, .kind = kind}, series, precision);
  transaction.commit();
  return id;
}

std::optional<TraceId> ResultStore::find_trace(TrialId trial, TraceKind kind,
                                               std::optional<ComparisonId> comparison) const {
  return lacuna::find_trace(database_, {.trial = trial, .comparison = comparison, .kind = kind});
}

TimeSeries ResultStore::trace(TraceId trace) const { return read_trace(database_, trace); }

}  // namespace lacuna
