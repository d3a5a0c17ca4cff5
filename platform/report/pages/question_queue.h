#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace lacuna {

/// Work that waits its turn for one of a few threads, in the order in which it came.
class QuestionQueue {
 public:
  QuestionQueue(int threads, std::size_t most_waiting);
  /// Waits for running work; waiting work is dropped.
  ~QuestionQueue();
  QuestionQueue(const QuestionQueue&) = delete;
  QuestionQueue& operator=(const QuestionQueue&) = delete;

  /// False: as much waits already as may. Work that nobody wants any more, as `is_wanted` tells, waits for nothing: it
  /// makes room and is not done. Neither may throw.
  bool add(
      std::function<void()> work, std::function<bool()> is_wanted = [] { return true; });

 private:
  struct Job {
    std::function<void()> work;
    std::function<bool()> is_wanted;
  };
  void do_work(const std::stop_token& stopped);

  const std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable_any added_;
  std::deque<Job> waiting_;
  std::vector<std::jthread> threads_;
};

}  // namespace lacuna
