#pragma once

#include "app/runs/open_eea_run.h"
#include "app/runs/replicate.h"
#include "app/runs/run_display.h"
#include "isolation/worker_pool.h"
#include "storage/eea/eea_store.h"

#include <mutex>
#include <vector>

namespace lacuna {

/// Runs replicates side by side, each in a run of its own in the database: first the replicates share the threads, then
/// the individuals of each. A replicate that fails does not end the others; Ctrl-C ends all after their generation.
class Replicates {
 public:
  /// `workers`: processes that simulate the models; null: this one does. They must outlive it.
  Replicates(const OpenEeaRun& opened, Database& database, ExperimentId experiment, WorkerPool* workers = nullptr)
      : opened_(opened), database_(database), experiment_(experiment), workers_(workers) {}

  /// Writes down what the runs are about, so that each can be gone on with, even one that never got its turn.
  void enter(const std::vector<PlannedReplicate>& planned);
  std::vector<ReplicateEnd> run(const std::vector<PlannedReplicate>& planned, int threads, RunDisplay& display);

 private:
  void carry_out(std::size_t index, int threads, RunDisplay& display, ReplicateEnd& end);
  void end_those_without_a_turn(const std::vector<ReplicateEnd>& ends);
  EeaRunRecord record(int replicate) const;
  EeaState state_of(EeaStore& store) const;

  const OpenEeaRun& opened_;
  Database& database_;
  ExperimentId experiment_;
  WorkerPool* workers_;
  std::mutex writing_;
};

}  // namespace lacuna
