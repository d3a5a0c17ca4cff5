#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace lacuna {

/// Work that waits its turn for one of a few threads, in the order in which it came.
class WorkQueue {
 public:
  WorkQueue(int threads, std::size_t most_waiting);
  /// Waits for what is being done; what only waits is forgotten.
  ~WorkQueue();
  WorkQueue(const WorkQueue&) = delete;
  WorkQueue& operator=(const WorkQueue&) = delete;

  /// False: as much waits already as may. Work must not throw.
  bool add(std::function<void()> work);

 private:
  void do_work(const std::stop_token& stopped);

  const std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable_any added_;
  std::deque<std::function<void()>> waiting_;
  std::vector<std::jthread> threads_;
};

}  // namespace lacuna
