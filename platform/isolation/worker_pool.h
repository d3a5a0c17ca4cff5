#pragma once

#include "isolation/worker_process.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace lacuna {

/// Worker processes that the replicates of an experiment take and return. Shared by threads.
class WorkerPool {
 public:
  /// `stop`: of the work that they share.
  WorkerPool(WorkerTask task, const Stop& stop) : task_(std::move(task)), stop_(stop) {}

  const Stop& stop() const { return stop_; }

  /// An idle one, or a new one.
  std::unique_ptr<WorkerProcess> take();
  void give_back(std::unique_ptr<WorkerProcess> worker);

  /// Counts a process that has ended. Throws `Error` the third time for its component, or for an unknown cause.
  void note_lost(const LostWork& lost);

 private:
  WorkerTask task_;
  Stop stop_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<WorkerProcess>> idle_;
  std::map<std::string, int> lost_;  ///< by component
};

}  // namespace lacuna
