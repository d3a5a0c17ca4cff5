#include "isolation/worker_pool.h"

#include <fmt/format.h>

#include <utility>

namespace lacuna {
namespace {

constexpr int kMostLost = 3;

std::string sentence_of(const LostWork& lost) {
  if (lost.component.empty())
    return fmt::format(
        "{} worker processes have ended, the last one so: {}. If memory is short, give the run fewer --threads; if "
        "models need more time, raise --evaluation-limit; otherwise please report the command",
        kMostLost, lost.deed);
  return fmt::format(
      "{} has ended {} worker processes, the last one so: {}; repair the plugin or leave this component out",
      lost.component, kMostLost, lost.deed);
}

}  // namespace

std::unique_ptr<WorkerProcess> WorkerPool::take() {
  {
    const std::scoped_lock lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<WorkerProcess> worker = std::move(idle_.back());
      idle_.pop_back();
      return worker;
    }
  }
  return std::make_unique<WorkerProcess>(task_, stop_);
}

void WorkerPool::give_back(std::unique_ptr<WorkerProcess> worker) {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(worker));
}

void WorkerPool::note_lost(const LostWork& lost) {
  const std::scoped_lock lock(mutex_);
  if (++lost_[lost.component] >= kMostLost) throw Error(sentence_of(lost));
}

}  // namespace lacuna
