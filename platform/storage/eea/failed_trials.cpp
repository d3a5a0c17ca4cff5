#include "storage/eea/failed_trials.h"

#include "storage/core/clock.h"
#include "storage/integrity/row_key.h"
#include "storage/core/statement.h"

namespace lacuna {

void record_failed_trial(const Database& database, RunId run, ExperimentId experiment,
                         const FailedTrialRecord& failed) {
  Statement(database,
            "INSERT INTO failed_trial (id, run, experiment, trial, test, failed, reason) VALUES (?, ?, ?, ?, ?, ?, ?)")
      .run_with(next_key(database, "failed_trial", run), run, experiment, failed.trial, failed.test, utc_now(),
                failed.reason);
}

}  // namespace lacuna
