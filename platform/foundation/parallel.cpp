#include "foundation/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace lacuna {

int default_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t, int)>& work) {
  const int workers = static_cast<int>(std::min<std::size_t>(count, static_cast<std::size_t>(std::max(threads, 1))));
  std::atomic<std::size_t> next{0};
  std::mutex failure_mutex;
  std::exception_ptr failure;
  std::size_t failed_index = count;

  const auto serve = [&](int worker) {
    for (std::size_t index = next++; index < count; index = next++) {
      try {
        work(index, worker);
      } catch (...) {
        const std::scoped_lock lock(failure_mutex);
        if (index < failed_index) {
          failed_index = index;
          failure = std::current_exception();
        }
      }
    }
  };

  {
    std::vector<std::jthread> helpers;
    try {
      for (int worker = 1; worker < workers; ++worker) helpers.emplace_back(serve, worker);
    } catch (const std::system_error&) {  // memory or a limit is used up: fewer threads do the same work
    }
    if (workers > 0) serve(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace lacuna
